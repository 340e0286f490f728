package org.SEAR.camera.image;

import org.SEAR.POJOs.Camera;

/**
 * From what is seen to what a sensor makes of it: the light times the exposure, in electrons whose number differs by its square root, and what
 * reading adds. Light is reckoned from pictures by the curve of sRGB (IEC 61966-2-1) and back. Immutable, any thread.
 */
public final class Exposure {
    private static final int FULL = 255;
    /** sRGB: up to here in a straight line, then a power. */
    private static final double KNEE = 0.04045;
    private static final double SLOPE = 12.92;
    private static final double OFFSET = 0.055;
    private static final double GAMMA = 2.4;
    /** Light of each value of a picture, and light half way to the next one. */
    private static final double[] LIGHT = new double[FULL + 1];
    private static final double[] HALF_WAY = new double[FULL];
    /** The values of pictures of evenly spaced light, so closely that the next light has the same or the next but one. */
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

    /** As a camera has it. */
    public Exposure(Camera camera) {
        factor = camera.getExposure();
        fullWell = camera.getFullWell();
        readNoise = camera.getReadNoise();
    }

    /** Random numbers of a picture. */
    public interface Noise {
        /** Normal with mean 0 and standard deviation 1: of one of the picture's numbers, of the light's own or of reading. */
        double normal(boolean reading, int number);
    }

    private static double light(double value) {
        double share = value / FULL;
        return share <= KNEE ? share / SLOPE : StrictMath.pow((share + OFFSET) / (1 + OFFSET), GAMMA);
    }

    /** Whether what is seen is what comes out. */
    public boolean isPlain() {
        return factor == 1 && fullWell == 0;
    }

    /** Changes a picture, 0xRRGGBB each. */
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

    /** The value of a picture that is nearest to a light, from one that is not above it. */
    private static int value(int least, double light) {
        int value = least;
        while (value < FULL && light >= HALF_WAY[value]) {
            value++;
        }
        return value;
    }
}
