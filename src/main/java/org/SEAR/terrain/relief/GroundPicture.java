// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.relief;

/**
 * Picture of the ground from above including sunlight: an aerial picture, one colour, or colours by elevation and
 * slope. Rows go from south to north. Immutable, any thread.
 */
public final class GroundPicture {
    /** Light of maps: from the north-west, 45 degrees above the horizon. */
    public static final HillShade MAP_LIGHT = new HillShade(315, 45);
    /** Tints of elevation on a map. */
    private static final ColorRamp TINTS = new ColorRamp(new float[] {0, 0.62f, 0.75f, 0.55f},
        new float[] {0.22f, 0.78f, 0.84f, 0.62f},
        new float[] {0.45f, 0.93f, 0.90f, 0.70f}, new float[] {0.68f, 0.88f, 0.77f, 0.57f},
        new float[] {0.86f, 0.76f, 0.62f, 0.49f}, new float[] {1, 0.95f, 0.93f, 0.91f});
    /** Mean slope, metres per metre, below which shading exaggerates the relief to make it visible. */
    private static final double VISIBLE_SLOPE = 0.3;
    private static final double MAX_EXAGGERATION = 3;
    /** Number of ridge-detection windows along the longer side of the picture. */
    private static final int RIDGES = 60;
    private static final double RIDGE_LIGHT = 0.13;
    private static final double GRAIN = 0.05;
    /** Share of shading that an aerial picture gets, as it already contains sunlight. */
    private static final double AERIAL = 0.55;

    /** Pixels from west to east, and from south to north. */
    public final int width;
    public final int height;
    /** 0xRRGGBB of each pixel, row by row from the south. */
    public final int[] pixels;

    private GroundPicture(Relief relief) {
        width = relief.width;
        height = relief.height;
        pixels = new int[width * height];
    }

    /** Given colours of the ground. */
    public interface Colors {
        /**
         * Returns the colour at a point of the world, metres.
         * @return 0xAARRGGBB with alpha 255; alpha 0 without a colour
         */
        int at(double x, double z);
    }

    /** Light on a landscape: {red, green, blue} of sky and sun, and the sun's direction. */
    public static final class Light {
        private final float[] sky;
        private final float[] sun;
        private final HillShade shade;

        public Light(float[] sky, float[] sun, HillShade shade) {
            this.sky = sky.clone();
            this.sun = sun.clone();
            this.shade = shade;
        }
    }

    /** Draws a landscape: the given colours, and colours by elevation and slope elsewhere or if given is null. */
    public static GroundPicture landscape(Relief relief, Light light, Colors given) {
        GroundPicture picture = new GroundPicture(relief);
        GroundColors natural = new GroundColors(relief);
        int wide = Math.max(2, Math.max(relief.width, relief.height) / RIDGES);
        float[] around = relief.blurred(wide, wide);
        double slope = relief.meanSlope();
        double exaggeration = Math.max(1, Math.min(MAX_EXAGGERATION, VISIBLE_SLOPE / Math.max(slope, 1e-9)));
        double ridges = Math.max(1e-9, slope * wide * Math.min(relief.stepX, relief.stepZ) / 2);
        float[] color = new float[3];
        for (int row = 0; row < relief.height; row++) {
            for (int column = 0; column < relief.width; column++) {
                int at = row * relief.width + column;
                double north = relief.slopeNorth(row, column);
                double east = relief.slopeEast(row, column);
                double ridge = Math.max(-1, Math.min(1, (relief.y(row, column) - around[at]) / ridges));
                double shade = light.shade.at(exaggeration * north, exaggeration * east);
                int own = given == null ? 0 : given.at(relief.x(row), relief.z(column));
                double plain = own >>> 24 == 0 ? 0 : 1 - AERIAL;
                double grain = own >>> 24 == 0 ? GRAIN * ValueNoise.value(row, column) : 0;
                if (own >>> 24 == 0) {
                    natural.at(row, column, Math.hypot(north, east), ridge, color);
                } else {
                    split(own, color);
                }
                double more = 1 + (1 - plain) * RIDGE_LIGHT * ridge + grain;
                for (int i = 0; i < 3; i++) {
                    double lit = (light.sky[i] + light.sun[i] * shade) * more;
                    color[i] *= (float) (plain + (1 - plain) * lit);
                }
                picture.pixels[at] = joined(color);
            }
        }
        return picture;
    }

    /** Draws a map with hill shading: the given colours, and tints of elevation elsewhere. */
    public static GroundPicture map(Relief relief, Colors given) {
        GroundPicture picture = new GroundPicture(relief);
        double exaggeration = Math.max(
            1, Math.min(MAX_EXAGGERATION, VISIBLE_SLOPE / Math.max(relief.meanSlope(), 1e-9)));
        double range = Math.max(1e-6, relief.highest - relief.lowest);
        double level = MAP_LIGHT.at(0, 0);
        float[] color = new float[3];
        for (int row = 0; row < relief.height; row++) {
            for (int column = 0; column < relief.width; column++) {
                int own = given == null ? 0 : given.at(relief.x(row), relief.z(column));
                if (own >>> 24 == 0) {
                    TINTS.at((relief.y(row, column) - relief.lowest) / range, color);
                } else {
                    split(own, color);
                }
                double shade = MAP_LIGHT.at(exaggeration * relief.slopeNorth(row, column),
                    exaggeration * relief.slopeEast(row, column)) / level;
                double light = 0.35 + 0.65 * shade;
                for (int i = 0; i < 3; i++) {
                    color[i] *= (float) Math.min(1.25, light);
                }
                picture.pixels[row * relief.width + column] = joined(color);
            }
        }
        return picture;
    }

    private static void split(int rgb, float[] color) {
        color[0] = (rgb >> 16 & 0xff) / 255f;
        color[1] = (rgb >> 8 & 0xff) / 255f;
        color[2] = (rgb & 0xff) / 255f;
    }

    private static int joined(float[] color) {
        int rgb = 0;
        for (int i = 0; i < 3; i++) {
            rgb = rgb << 8 | Math.max(0, Math.min(255, Math.round(color[i] * 255)));
        }
        return rgb;
    }
}
