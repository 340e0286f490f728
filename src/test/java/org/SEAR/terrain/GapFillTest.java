// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Gaps in a map are filled from their surroundings. */
public class GapFillTest {
    private static final int SIDE = 64;

    private static float[] slope() {
        float[] heights = new float[SIDE * SIDE];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = 3 * (i / SIDE) - 2 * (i % SIDE);
        }
        return heights;
    }

    @Test
    public void aHoleInASlopeIsSlopeAgain() {
        float[] heights = slope();
        for (int row = 20; row < 40; row++) {
            for (int column = 10; column < 30; column++) {
                heights[row * SIDE + column] = Float.NaN;
            }
        }
        GapFill.fill(heights, SIDE, SIDE);
        float[] wanted = slope();
        for (int i = 0; i < heights.length; i++) {
            assertEquals("post " + i, wanted[i], heights[i], 3);
        }
    }

    @Test
    public void filledElevationsStayWithinThoseOfTheRim() {
        float[] heights = slope();
        for (int i = 0; i < heights.length / 2; i++) {
            heights[i * 7 % heights.length] = Float.NaN;
        }
        float[] again = heights.clone();
        GapFill.fill(heights, SIDE, SIDE);
        for (float height : heights) {
            assertTrue(height >= -2 * SIDE && height <= 3 * SIDE);
        }
        GapFill.fill(again, SIDE, SIDE);
        assertArrayEquals(heights, again, 0);
    }

    @Test
    public void oneHeightIsEnough() {
        float[] heights = {Float.NaN, Float.NaN, Float.NaN, Float.NaN, 7, Float.NaN};
        GapFill.fill(heights, 2, 3);
        assertArrayEquals(new float[] {7, 7, 7, 7, 7, 7}, heights, 1e-4f);
    }
}
