// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.relief;

import java.util.Random;

/** Detail texture of nearby ground: tileable grey noise of several octaves. Any thread. */
public final class GroundGrain {
    /** Size of the texture, pixels. */
    public static final int SIDE = 512;
    /** Distance at which the grain has faded out, metres. */
    public static final float FAR = 150;
    /** Period of the grain, metres. */
    public static final double REPEATED = 9.6;
    private static final int OCTAVES = 7;

    private GroundGrain() {
    }

    /** Returns the brightness of each pixel, row by row; 128 leaves the ground unchanged. */
    public static byte[] grey() {
        return grey(new Random(SIDE));
    }

    private static byte[] grey(Random random) {
        float[] sum = new float[SIDE * SIDE];
        for (int octave = 2; octave < 2 + OCTAVES; octave++) {
            int cells = 1 << octave;
            float[] values = new float[cells * cells];
            for (int i = 0; i < values.length; i++) {
                values[i] = random.nextFloat() - 0.5f;
            }
            for (int i = 0; i < sum.length; i++) {
                int row = i / SIDE;
                int column = i % SIDE;
                sum[i] += 0.3f * smooth(values, cells, (float) row * cells / SIDE, (float) column * cells / SIDE);
            }
        }
        byte[] grey = new byte[sum.length];
        for (int i = 0; i < sum.length; i++) {
            grey[i] = (byte) Math.max(0, Math.min(255, Math.round(128 + 255 * sum[i])));
        }
        return grey;
    }

    private static float smooth(float[] values, int cells, float x, float y) {
        int row = (int) x;
        int column = (int) y;
        float u = x - row;
        float v = y - column;
        u = u * u * (3 - 2 * u);
        v = v * v * (3 - 2 * v);
        int above = (row + 1) % cells;
        int right = (column + 1) % cells;
        return (values[row * cells + column] * (1 - v) + values[row * cells + right] * v) * (1 - u)
            + (values[above * cells + column] * (1 - v) + values[above * cells + right] * v) * u;
    }
}
