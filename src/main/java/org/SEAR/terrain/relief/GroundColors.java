// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.relief;

/**
 * Colours of natural ground before lighting: meadows and woods low down, grass and rock further up, snow on high
 * mountains, rock on steep slopes. Elevation is relative to the terrain's own range. Any thread.
 */
final class GroundColors {
    /** Colours by elevation: 0 is the lowest point, 1 the top of a mountain high enough for snow. */
    private static final ColorRamp HEIGHTS = new ColorRamp(new float[] {0, 0.53f, 0.56f, 0.34f},
        new float[] {0.16f, 0.45f, 0.51f, 0.29f},
        new float[] {0.38f, 0.36f, 0.43f, 0.24f}, new float[] {0.55f, 0.37f, 0.41f, 0.24f},
        new float[] {0.70f, 0.50f, 0.48f, 0.33f},
        new float[] {0.82f, 0.54f, 0.50f, 0.44f}, new float[] {0.92f, 0.66f, 0.65f, 0.63f},
            new float[] {0.97f, 0.93f, 0.94f, 0.96f});
    private static final float[] WOOD = {0.22f, 0.31f, 0.17f};
    private static final float[] ROCK = {0.52f, 0.48f, 0.42f};
    /** End of the ramp for a low relief: meadows and woods only. */
    private static final double LOW_TOP = 0.56;
    /** Elevation range, metres, up to which the ramp ends at {@link #LOW_TOP}, and from which it reaches snow. */
    private static final double HILLS = 350;
    private static final double MOUNTAINS = 2600;
    /** Slopes between which rock appears, metres per metre. */
    private static final double GRASSY = 0.75;
    private static final double ROCKY = 1.5;
    /** Minimum and maximum size of a wood, metres. */
    private static final double SMALLEST_WOOD = 12;
    private static final double LARGEST_WOOD = 900;

    private final Relief relief;
    private final double range;
    private final double top;
    private final double wood;

    GroundColors(Relief relief) {
        this.relief = relief;
        range = Math.max(1e-6, relief.highest - relief.lowest);
        top = LOW_TOP + (1 - LOW_TOP) * Math.max(0, Math.min(1, Math.log(range / HILLS) / Math.log(MOUNTAINS / HILLS)));
        double extent = Math.max(relief.width * relief.stepZ, relief.height * relief.stepX);
        wood = Math.max(Math.min(SMALLEST_WOOD, extent / 8), Math.min(LARGEST_WOOD, extent / 30));
    }

    /**
     * Writes the colour of a pixel.
     * @param steep slope, metres per metre
     * @param ridge from -1 in a valley to 1 on a ridge
     * @param into receives red, green and blue
     */
    void at(int row, int column, double steep, double ridge, float[] into) {
        double x = relief.x(row) / wood;
        double z = relief.z(column) / wood;
        double patches = ValueNoise.fractal(x, z);
        double place = top * (relief.y(row, column) - relief.lowest) / range;
        HEIGHTS.at(place + 0.05 * patches + 0.03 * ridge, into);
        double wooded = between(0.02, 0.3, patches - 0.35 * ridge) * between(0.03, 0.15, place) * (
            1 - between(0.5, 0.66, place));
        mix(into, WOOD, 0.75 * wooded);
        mix(into, ROCK, between(GRASSY, ROCKY, steep + 0.2 * patches) * (
            1 - between(0.9, 0.97, place) * between(ROCKY, GRASSY, steep)));
    }

    private static double between(double low, double high, double value) {
        double share = Math.max(0, Math.min(1, (value - low) / (high - low)));
        return share * share * (3 - 2 * share);
    }

    private static void mix(float[] color, float[] other, double share) {
        for (int i = 0; i < 3; i++) {
            color[i] += (float) share * (other[i] - color[i]);
        }
    }
}
