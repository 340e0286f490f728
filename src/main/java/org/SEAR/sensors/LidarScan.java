package org.SEAR.sensors;

import java.util.Arrays;

/**
 * What a plane of beams measured in one step. Immutable; any thread. The first range is the rightmost beam's, the last the leftmost's; the middle
 * beam looks along the sensor's forward axis.
 */
public final class LidarScan implements Reading {
    private static final int DIGITS = 3;

    private final double spread;
    private final double resolution;
    private final double range;
    private final double[] ranges;

    /**
     * @param spread degrees from the rightmost to the leftmost beam
     * @param resolution degrees between two beams
     * @param range farthest that a beam can tell, metres
     * @param ranges metres, right to left, +infinity where nothing was hit; belongs to the scan from now on
     */
    public LidarScan(double spread, double resolution, double range, double[] ranges) {
        this.spread = spread;
        this.resolution = resolution;
        this.range = range;
        this.ranges = ranges;
    }

    /** Degrees from the rightmost to the leftmost beam. */
    public double getSpread() {
        return spread;
    }

    /** Degrees between two neighbouring beams. */
    public double getResolution() {
        return resolution;
    }

    /** Farthest that a beam can tell, metres. */
    public double getMaxRange() {
        return range;
    }

    /** Number of beams. */
    public int size() {
        return ranges.length;
    }

    /**
     * Metres along a beam, +infinity where nothing was hit.
     *
     * @param beam 0 (rightmost) to size() - 1
     */
    public double range(int beam) {
        return ranges[beam];
    }

    /** Angle of a beam from the forward axis, degrees, + to the left. */
    public double angle(int beam) {
        return beam * resolution - spread / 2;
    }

    /** A copy of the ranges: metres, right to left, +infinity where nothing was hit. */
    public double[] ranges() {
        return ranges.clone();
    }

    private double nearest() {
        return Arrays.stream(ranges).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** The nearest distance, infinite where nothing is in range. */
    @Override
    public double[] numbers() {
        return new double[] {nearest()};
    }

    /** A float[]: metres, right to left; the range where nothing was hit. */
    @Override
    public Object value() {
        float[] metres = new float[ranges.length];
        for (int i = 0; i < metres.length; i++) {
            metres[i] = (float) Math.min(ranges[i], range);
        }
        return metres;
    }

    @Override
    public String words(String unit) {
        long hits = Arrays.stream(ranges).filter(metres -> metres < Double.POSITIVE_INFINITY).count();
        return words(numbers(), unit) + (hits == 0 ? "" : ", " + hits + " of " + ranges.length + " beams hit");
    }

    @Override
    public String words(double[] kept, String unit) {
        return kept[0] == Double.POSITIVE_INFINITY ? "nothing within " + ReadingWords.withUnit(ReadingWords.plain(range), unit)
            : "nearest " + ReadingWords.withUnit(ReadingWords.fixed(kept, DIGITS), unit);
    }

    @Override
    public LidarScan scan() {
        return this;
    }
}
