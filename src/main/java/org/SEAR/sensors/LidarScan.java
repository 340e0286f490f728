package org.SEAR.sensors;

/**
 * What a plane of beams measured in one step. Immutable; any thread. The first range is the rightmost beam's, the last the leftmost's; the middle
 * beam looks along the sensor's forward axis.
 */
public final class LidarScan {
    private final double spread;
    private final double resolution;
    private final double[] ranges;

    /**
     * @param spread degrees from the rightmost to the leftmost beam
     * @param resolution degrees between two beams
     * @param ranges metres, right to left, +infinity where nothing was hit; belongs to the scan from now on
     */
    public LidarScan(double spread, double resolution, double[] ranges) {
        this.spread = spread;
        this.resolution = resolution;
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
}
