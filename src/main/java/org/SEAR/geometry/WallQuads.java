// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import java.util.Arrays;

/** Growing list of the sides and tops of walls. */
final class WallQuads {
    private static final int CORNERS = 4;
    private static final int NUMBERS = 3 * CORNERS;

    private float[] corners = new float[1 << 12];
    private int count;

    int size() {
        return count;
    }

    private void corner(int n, double x, double y, double z) {
        int at = NUMBERS * count + 3 * n;
        corners[at] = (float) x;
        corners[at + 1] = (float) y;
        corners[at + 2] = (float) z;
    }

    private void grow() {
        if (NUMBERS * count + NUMBERS > corners.length) {
            corners = Arrays.copyOf(corners, 2 * corners.length);
        }
    }

    /** Adds a side from y = -half to half, from left to right for those who look at it from outside. */
    void side(double fromX, double fromZ, double toX, double toZ, double half) {
        grow();
        corner(0, fromX, -half, fromZ);
        corner(1, toX, -half, toZ);
        corner(2, toX, half, toZ);
        corner(3, fromX, half, fromZ);
        count++;
    }

    /** Adds a top at a height; its corners {x, z} are counter-clockwise from above. */
    void top(double[][] around, double height) {
        grow();
        for (int n = 0; n < CORNERS; n++) {
            corner(n, around[n][0], height, around[n][1]);
        }
        count++;
    }

    Triangles triangles() {
        int[] indices = new int[6 * count];
        for (int i = 0; i < count; i++) {
            for (int n = 0; n < 6; n++) {
                indices[6 * i + n] = CORNERS * i + (n < 3 ? n : n == 3 ? 0 : n - 2);
            }
        }
        return new Triangles(Arrays.copyOf(corners, NUMBERS * count), indices);
    }
}
