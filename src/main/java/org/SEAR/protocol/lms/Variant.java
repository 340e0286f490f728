// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

/**
 * A scanning angle with its resolution. The first value is the rightmost. The 100 degree variants cover 40 to 140
 * degrees of the 180.
 */
public enum Variant {
    V100_1(100, 100),
    V100_HALF(100, 50),
    V100_QUARTER(100, 25),
    V180_1(180, 100),
    V180_HALF(180, 50);

    /** Duration of one turn of the mirror at 75 turns per second, seconds (SICK telegram listing, table 10-17). */
    public static final double TURN = 0.01332;

    private static final double HUNDREDTHS = 100;

    private final int spread;
    private final int resolution;

    Variant(int spread, int resolution) {
        this.spread = spread;
        this.resolution = resolution;
    }

    /**
     * Finds the variant of a telegram; null if an LMS200 does not have it.
     *
     * @param spread degrees
     * @param resolution 1/100 degree
     */
    public static Variant of(int spread, int resolution) {
        for (Variant variant : values()) {
            if (variant.spread == spread && variant.resolution == resolution) {
                return variant;
            }
        }
        return null;
    }

    /** Finds a variant by angle and resolution in degrees; null if an LMS200 does not have it. */
    public static Variant ofDegrees(double spread, double resolution) {
        for (Variant variant : values()) {
            if (variant.spread == spread && variant.resolution == resolution * HUNDREDTHS) {
                return variant;
            }
        }
        return null;
    }

    /** Scanning angle, degrees. */
    public int getSpread() {
        return spread;
    }

    /** Resolution, 1/100 degree. */
    public int getResolution() {
        return resolution;
    }

    /** Number of values of a whole scan. */
    public int getValues() {
        return spread * 100 / resolution + 1;
    }

    /** Turns of the mirror per whole scan; each turn measures one value per degree. */
    public int getTurns() {
        return 100 / resolution;
    }

    /** Duration of a whole scan, seconds. */
    public double getScanTime() {
        return getTurns() * TURN;
    }
}
