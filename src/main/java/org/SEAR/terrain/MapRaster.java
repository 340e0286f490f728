// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

/**
 * Elevations read from a map, unchanged. The first value belongs to the map's post {@link #row}, {@link #column}.
 * Immutable after gaps are filled; then any thread.
 */
final class MapRaster {
    final int row;
    final int column;
    final int rows;
    final int columns;
    /** Metres, row by row; NaN for no data. */
    final float[] heights;

    MapRaster(int row, int column, int rows, int columns, float[] heights) {
        this.row = row;
        this.column = column;
        this.rows = rows;
        this.columns = columns;
        this.heights = heights;
    }

    /**
     * Returns the elevation at a position of the map, bilinear between four posts, clamped to the outermost posts.
     * @param atColumn the map's fractional column, likewise atRow
     */
    double height(double atColumn, double atRow) {
        double c = Math.max(0, Math.min(columns - 1, atColumn - column));
        double r = Math.max(0, Math.min(rows - 1, atRow - row));
        int left = Math.min((int) c, columns - 2);
        int top = Math.min((int) r, rows - 2);
        return between(top * columns + left, c - left, r - top);
    }

    /**
     * Returns exactly the elevation that a larger raster has at a position. This part of it must contain the four
     * surrounding posts.
     */
    double height(RasterFile whole, double atColumn, double atRow) {
        double c = Math.max(0, Math.min(whole.columns - 1, atColumn - whole.column));
        double r = Math.max(0, Math.min(whole.rows - 1, atRow - whole.row));
        int left = Math.min((int) c, whole.columns - 2);
        int top = Math.min((int) r, whole.rows - 2);
        return between((top + whole.row - row) * columns + left + whole.column - column, c - left, r - top);
    }

    private double between(int at, double u, double v) {
        double upper = heights[at] + u * (heights[at + 1] - heights[at]);
        double lower = heights[at + columns] + u * (heights[at + columns + 1] - heights[at + columns]);
        return upper + v * (lower - upper);
    }

    /** Returns whether the nearest post has no data. */
    boolean isEmpty(double atColumn, double atRow) {
        int c = (int) Math.max(0, Math.min(columns - 1, Math.rint(atColumn - column)));
        int r = (int) Math.max(0, Math.min(rows - 1, Math.rint(atRow - row)));
        return Float.isNaN(heights[r * columns + c]);
    }

    /** Returns the minimum and maximum, metres. */
    double[] range() {
        float low = Float.POSITIVE_INFINITY;
        float high = Float.NEGATIVE_INFINITY;
        for (float height : heights) {
            low = Math.min(low, height);
            high = Math.max(high, height);
        }
        return new double[] {low, high};
    }

    /** Returns whether any post has no data. */
    boolean hasGaps() {
        for (float height : heights) {
            if (Float.isNaN(height)) {
                return true;
            }
        }
        return false;
    }
}
