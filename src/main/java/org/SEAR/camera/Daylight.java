// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

import org.SEAR.terrain.relief.GroundPicture;
import org.SEAR.terrain.relief.HillShade;

/**
 * Light of every world: the sun, ambient light of the sky, and the sky itself. The window and the cameras use the same.
 * Colours are sRGB, and both compute with them as such. Immutable, any thread.
 */
public final class Daylight {
    /** Share of the light that a shadow removes. */
    public static final float SHADOW = 0.45f;
    /** Degrees by which the sun is lower on landscapes, so that hills show their sides. */
    private static final double LOWER_SUN = 8;
    private static final float[] SUN = {0.82f, 0.79f, 0.72f};
    private static final float[] SKY = {0.50f, 0.53f, 0.58f};
    /** Direction of the sunlight, not normalised. */
    private static final double[] SUNLIGHT = {-0.45, -0.8, 0.4};
    /**
     * Rings of the sky from the bottom to the top: degrees above the horizon, red, green, blue. The colour gets deeper
     * upwards. Two rings make a sharp horizon; below it is the haze of distant land.
     */
    private static final float[][] RINGS = {{-90, 0.36f, 0.40f, 0.33f}, {-40, 0.42f, 0.46f, 0.37f},
        {-12, 0.54f, 0.58f, 0.48f},
        {-3, 0.67f, 0.71f, 0.63f}, {0, 0.75f, 0.79f, 0.76f}, {0, 0.87f, 0.92f, 0.95f}, {4, 0.78f, 0.87f, 0.95f},
        {12, 0.63f, 0.78f, 0.93f},
        {30, 0.45f, 0.65f, 0.88f}, {60, 0.31f, 0.52f, 0.81f}, {90, 0.26f, 0.47f, 0.77f}};

    private Daylight() {
    }

    /** Returns red, green and blue of the sunlight, 0 to 1. */
    public static float[] sun() {
        return SUN.clone();
    }

    /** Returns red, green and blue of the ambient light, 0 to 1. */
    public static float[] sky() {
        return SKY.clone();
    }

    /** Returns the unit direction to the sun: {x, y, z}, world frame. */
    public static double[] toSun() {
        double length = Math.sqrt(SUNLIGHT[0] * SUNLIGHT[0] + SUNLIGHT[1] * SUNLIGHT[1] + SUNLIGHT[2] * SUNLIGHT[2]);
        return new double[] {-SUNLIGHT[0] / length, -SUNLIGHT[1] / length, -SUNLIGHT[2] / length};
    }

    /** Returns the rings of the sky from the bottom to the top: degrees above the horizon, red, green, blue, 0 to 1. */
    public static float[][] rings() {
        float[][] rings = new float[RINGS.length][];
        for (int i = 0; i < rings.length; i++) {
            rings[i] = RINGS[i].clone();
        }
        return rings;
    }

    /** Returns the light on a landscape, for pictures that contain it. */
    public static GroundPicture.Light onLandscape() {
        double[] sun = toSun();
        double azimuth = Math.toDegrees(Math.atan2(sun[2], sun[0]));
        HillShade shade = new HillShade(azimuth, Math.toDegrees(Math.asin(sun[1])) - LOWER_SUN);
        return new GroundPicture.Light(sky(), sun(), shade);
    }
}
