// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

/**
 * Colour of the sky by direction, as the window draws it: flat bands between rings, coloured linearly. Immutable, any
 * thread.
 */
final class SkyBackground {
    private static final double FULL = 255;
    private static final float[][] RINGS = Daylight.rings();
    private static final double[] SIN = new double[RINGS.length];
    private static final double[] COS = new double[RINGS.length];

    static {
        for (int i = 0; i < RINGS.length; i++) {
            SIN[i] = StrictMath.sin(StrictMath.toRadians(RINGS[i][0]));
            COS[i] = StrictMath.cos(StrictMath.toRadians(RINGS[i][0]));
        }
    }

    private SkyBackground() {
    }

    /**
     * Sets the colour of the sky in a direction of any length but 0.
     *
     * @param spot takes red, green and blue
     */
    static void look(double dx, double dy, double dz, SurfaceHit spot) {
        double level = Math.sqrt(dx * dx + dz * dz);
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double sine = dy / length;
        double cosine = level / length;
        int ring = sine >= 0 ? RINGS.length / 2 : 0;
        while (ring < RINGS.length - 2 && sine > SIN[ring + 1]) {
            ring++;
        }
        // share of the straight line from the lower to the upper ring at which the direction crosses it
        double below = sine * COS[ring] - cosine * SIN[ring];
        double above = SIN[ring + 1] * cosine - COS[ring + 1] * sine;
        double part = below + above == 0 ? 0 : Math.max(0, Math.min(1, below / (below + above)));
        float[] low = RINGS[ring];
        float[] high = RINGS[ring + 1];
        spot.red = FULL * (low[1] + part * (high[1] - low[1]));
        spot.green = FULL * (low[2] + part * (high[2] - low[2]));
        spot.blue = FULL * (low[3] + part * (high[3] - low[3]));
    }
}
