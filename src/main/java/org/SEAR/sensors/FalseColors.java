// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/** False colours: a rainbow from the lowest to the highest number of a picture. Any thread. */
final class FalseColors {
    private static final int FULL = 255;
    /** Sixths of the hue circle from red to blue. */
    private static final double SIXTHS = 4;

    private FalseColors() {
    }

    /**
     * Returns 0xRRGGBB for each number; black if it is not finite.
     *
     * @param redLeast whether red is the lowest or the highest
     */
    static int[] of(float[] values, boolean redLeast) {
        float least = Float.POSITIVE_INFINITY;
        float most = Float.NEGATIVE_INFINITY;
        for (float value : values) {
            if (Float.isFinite(value)) {
                least = Math.min(least, value);
                most = Math.max(most, value);
            }
        }
        int[] colors = new int[values.length];
        for (int i = 0; i < values.length; i++) {
            if (Float.isFinite(values[i])) {
                double share = most > least ? (values[i] - least) / (double) (most - least) : 0;
                colors[i] = hue(SIXTHS * (redLeast ? share : 1 - share));
            }
        }
        return colors;
    }

    /** @param sixth 0 red, 1 yellow, 2 green, 3 cyan, 4 blue */
    private static int hue(double sixth) {
        int red = channel(2 - sixth);
        int green = channel(sixth < 2 ? sixth : SIXTHS - sixth);
        int blue = channel(sixth - 2);
        return red << 16 | green << 8 | blue;
    }

    private static int channel(double share) {
        return (int) Math.round(FULL * Math.max(0, Math.min(1, share)));
    }
}
