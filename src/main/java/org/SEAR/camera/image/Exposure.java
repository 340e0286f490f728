// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera.image;

import org.SEAR.POJOs.Camera;

/**
 * Sensor model: light times exposure gives electrons with shot noise (standard deviation is the square root of their
 * number) and read noise. Converts between pictures and linear light by the sRGB curve (IEC 61966-2-1). Immutable, any
 * thread.
 */
public final class Exposure {
    private static final int FULL = 255;
    /** sRGB: the curve is linear up to this value, then a power. */
    private static final double KNEE = 0.04045;
    private static final double SLOPE = 12.92;
    private static final double OFFSET = 0.055;
    private static final double GAMMA = 2.4;
    /** Linear light of each picture value, and of the midpoint to the next one. */
    private static final double[] LIGHT = new double[FULL + 1];
    private static final double[] HALF_WAY = new double[FULL];
    /** Lower bounds of the picture values for evenly spaced light; neighbours differ by at most two. */
    private static final int[] VALUES = new int[4096];

    static {
        for (int i = 0; i <= FULL; i++) {
            LIGHT[i] = light(i);
        }
        for (int i = 0; i < FULL; i++) {
            HALF_WAY[i] = light(i + 0.5);
        }
        for (int i = 1; i < VALUES.length; i++) {
            VALUES[i] = value(VALUES[i - 1], (double) i / VALUES.length);
        }
    }

    private final double factor;
    private final double fullWell;
    private final double readNoise;

    /** Takes a camera's exposure, full well and read noise. */
    public Exposure(Camera camera) {
        factor = camera.getExposure();
        fullWell = camera.getFullWell();
        readNoise = camera.getReadNoise();
    }

    /** Random numbers for a picture. */
    public interface Noise {
        /** Returns a standard normal number for a value of the picture: shot noise or read noise. */
        double normal(boolean reading, int number);
    }

    private static double light(double value) {
        double share = value / FULL;
        return share <= KNEE ? share / SLOPE : StrictMath.pow((share + OFFSET) / (1 + OFFSET), GAMMA);
    }

    /** Returns whether pictures stay unchanged. */
    public boolean isPlain() {
        return factor == 1 && fullWell == 0;
    }

    /** Applies exposure and noise to pixels, 0xRRGGBB each. */
    public void expose(int[] pixels, Noise noise) {
        for (int i = 0; i < pixels.length && !isPlain(); i++) {
            int rgb = pixels[i];
            pixels[i] = value(rgb >> 16 & 0xff, 3 * i, noise) << 16 | value(rgb >> 8 & 0xff, 3 * i + 1, noise) << 8
                | value(rgb & 0xff, 3 * i + 2, noise);
        }
    }

    private int value(int seen, int number, Noise noise) {
        double light = LIGHT[seen] * factor;
        if (fullWell > 0) {
            double electrons = Math.min(1, light) * fullWell;
            electrons += Math.sqrt(electrons) * noise.normal(false, number);
            if (readNoise > 0) {
                electrons += readNoise * noise.normal(true, number);
            }
            light = electrons / fullWell;
        }
        return light < 1 ? value(VALUES[(int) (Math.max(0, light) * VALUES.length)], light) : FULL;
    }

    /** Returns the picture value nearest to a light, searching upwards from a lower bound. */
    private static int value(int least, double light) {
        int value = least;
        while (value < FULL && light >= HALF_WAY[value]) {
            value++;
        }
        return value;
    }
}
