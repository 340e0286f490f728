// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;

/**
 * Fills gaps of a raster by interpolation: each post of a gap becomes the mean of its neighbours, like a membrane
 * stretched over the rim. A raster of half the size, filled likewise, gives the start values. Deterministic. Any
 * thread.
 */
final class GapFill {
    private static final int SWEEPS = 20;

    private GapFill() {
    }

    /**
     * Fills gaps in place.
     * @param heights row by row, at least one finite; NaN marks gaps
     */
    static void fill(float[] heights, int rows, int columns) {
        int[] gaps = gaps(heights);
        if (gaps.length == 0) {
            return;
        }
        if (rows > 1 || columns > 1) {
            int halfRows = (rows + 1) / 2;
            int halfColumns = (columns + 1) / 2;
            float[] half = half(heights, rows, columns, halfRows, halfColumns);
            fill(half, halfRows, halfColumns);
            for (int at : gaps) {
                heights[at] = half[at / columns / 2 * halfColumns + at % columns / 2];
            }
        }
        smooth(heights, gaps, rows, columns);
    }

    /**
     * Fills gaps in place from known start values.
     * @param heights row by row; NaN marks gaps
     * @param start start value of a post
     */
    static void fill(float[] heights, int rows, int columns, IntToDoubleFunction start) {
        int[] gaps = gaps(heights);
        for (int at : gaps) {
            heights[at] = (float) start.applyAsDouble(at);
        }
        smooth(heights, gaps, rows, columns);
    }

    private static void smooth(float[] heights, int[] gaps, int rows, int columns) {
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            for (int i = 0; i < gaps.length; i++) {
                int at = gaps[(sweep & 1) == 0 ? i : gaps.length - 1 - i];
                heights[at] = mean(heights, at / columns, at % columns, rows, columns);
            }
        }
    }

    private static int[] gaps(float[] heights) {
        int[] found = new int[16];
        int count = 0;
        for (int at = 0; at < heights.length; at++) {
            if (Float.isNaN(heights[at])) {
                if (count == found.length) {
                    found = Arrays.copyOf(found, Math.min(2 * count, heights.length));
                }
                found[count++] = at;
            }
        }
        return Arrays.copyOf(found, count);
    }

    private static float[] half(float[] heights, int rows, int columns, int halfRows, int halfColumns) {
        float[] half = new float[halfRows * halfColumns];
        for (int at = 0; at < half.length; at++) {
            int row = at / halfColumns * 2;
            int column = at % halfColumns * 2;
            double sum = 0;
            int count = 0;
            for (int r = row; r < Math.min(row + 2, rows); r++) {
                for (int c = column; c < Math.min(column + 2, columns); c++) {
                    if (!Float.isNaN(heights[r * columns + c])) {
                        sum += heights[r * columns + c];
                        count++;
                    }
                }
            }
            half[at] = count == 0 ? Float.NaN : (float) (sum / count);
        }
        return half;
    }

    private static float mean(float[] heights, int row, int column, int rows, int columns) {
        int at = row * columns + column;
        double sum = 0;
        int count = 0;
        if (row > 0) {
            sum += heights[at - columns];
            count++;
        }
        if (row < rows - 1) {
            sum += heights[at + columns];
            count++;
        }
        if (column > 0) {
            sum += heights[at - 1];
            count++;
        }
        if (column < columns - 1) {
            sum += heights[at + 1];
            count++;
        }
        return count == 0 ? heights[at] : (float) (sum / count);
    }
}
