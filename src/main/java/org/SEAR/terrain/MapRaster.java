package org.SEAR.terrain;

/**
 * Heights that were read of a map, as they are there; the first one is that of the map's post {@link #row}, {@link #column}. Nobody changes them
 * after the gaps are filled. Any thread then.
 */
final class MapRaster {
    final int row;
    final int column;
    final int rows;
    final int columns;
    /** Metres, row by row; NaN: the map has none. */
    final float[] heights;

    MapRaster(int row, int column, int rows, int columns, float[] heights) {
        this.row = row;
        this.column = column;
        this.rows = rows;
        this.columns = columns;
        this.heights = heights;
    }

    /**
     * The height at a place of the map, bilinear between four posts; beyond the outermost posts as at them.
     *
     * @param atColumn the map's column with fractions, likewise atRow
     */
    double height(double atColumn, double atRow) {
        double c = Math.max(0, Math.min(columns - 1, atColumn - column));
        double r = Math.max(0, Math.min(rows - 1, atRow - row));
        int left = Math.min((int) c, columns - 2);
        int top = Math.min((int) r, rows - 2);
        return between(top * columns + left, c - left, r - top);
    }

    /** The height that a larger raster has at a place, to the bit, when this is the part of it that has the four posts around. */
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

    /** Whether the post nearest to a place has no height. */
    boolean isEmpty(double atColumn, double atRow) {
        int c = (int) Math.max(0, Math.min(columns - 1, Math.rint(atColumn - column)));
        int r = (int) Math.max(0, Math.min(rows - 1, Math.rint(atRow - row)));
        return Float.isNaN(heights[r * columns + c]);
    }

    /** The lowest and the highest. */
    double[] range() {
        float low = Float.POSITIVE_INFINITY;
        float high = Float.NEGATIVE_INFINITY;
        for (float height : heights) {
            low = Math.min(low, height);
            high = Math.max(high, height);
        }
        return new double[] {low, high};
    }

    /** Whether any post has no height. */
    boolean hasGaps() {
        for (float height : heights) {
            if (Float.isNaN(height)) {
                return true;
            }
        }
        return false;
    }
}
