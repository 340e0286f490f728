// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Arrays;

/**
 * Ranges of a plane of beams. The first range is the rightmost beam's, the last the leftmost's; the middle
 * beam points along the sensor's forward axis. Immutable; any thread.
 */
public final class LidarScan implements Reading {
    private static final int DIGITS = 3;

    private final double spread;
    private final double resolution;
    private final double range;
    private final double[] ranges;
    private final long step;

    /**
     * A scan of step 0.
     *
     * @param spread degrees from the rightmost to the leftmost beam
     * @param resolution degrees between two beams
     * @param range maximum range of a beam, metres
     * @param ranges metres, right to left, +infinity without a hit; not copied
     */
    public LidarScan(double spread, double resolution, double range, double[] ranges) {
        this(spread, resolution, range, ranges, 0);
    }

    /** @param step of the simulation that measured the scan */
    LidarScan(double spread, double resolution, double range, double[] ranges, long step) {
        this.spread = spread;
        this.resolution = resolution;
        this.range = range;
        this.ranges = ranges;
        this.step = step;
    }

    /** Returns the step of the simulation that measured the scan. */
    long step() {
        return step;
    }

    /** Returns degrees from the rightmost to the leftmost beam. */
    public double getSpread() {
        return spread;
    }

    /** Returns degrees between two neighbouring beams. */
    public double getResolution() {
        return resolution;
    }

    /** Returns the maximum range of a beam, metres. */
    public double getMaxRange() {
        return range;
    }

    /** Returns the number of beams. */
    public int size() {
        return ranges.length;
    }

    /**
     * Returns metres along a beam, +infinity without a hit.
     *
     * @param beam 0 (rightmost) to size() - 1
     */
    public double range(int beam) {
        return ranges[beam];
    }

    /** Returns the angle of a beam from the forward axis, degrees, + left. */
    public double angle(int beam) {
        return beam * resolution - spread / 2;
    }

    /** Returns a copy of the ranges: metres, right to left, +infinity without a hit. */
    public double[] ranges() {
        return ranges.clone();
    }

    private double nearest() {
        return Arrays.stream(ranges).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** Returns the nearest distance; infinite without anything in range. */
    @Override
    public double[] numbers() {
        return new double[] {nearest()};
    }

    /** Returns a float[]: metres, right to left; the maximum range without a hit. */
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
        return kept[0] == Double.POSITIVE_INFINITY ? "nothing within "
            + ReadingWords.withUnit(ReadingWords.plain(range), unit)
            : "nearest " + ReadingWords.withUnit(ReadingWords.fixed(kept, DIGITS), unit);
    }

    @Override
    public LidarScan scan() {
        return this;
    }
}
