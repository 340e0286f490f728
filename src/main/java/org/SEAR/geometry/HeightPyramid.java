// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/**
 * Lowest and highest elevations of blocks of a {@link HeightField}: 2 x 2 cells at level 0, and 2 x 2 blocks of the
 * level below at each higher one, up to one block for all. Takes 2.7 bytes per post. Immutable, any thread.
 */
public final class HeightPyramid {
    /** Level of the single block that covers everything. */
    public final int top;
    /**
     * Lowest and highest elevation per block; +infinity and -infinity for blocks beside the field. See
     * {@link #children}.
     */
    public final float[] data;
    private final int[] from;
    private final int[] rows;
    private final int[] columns;

    HeightPyramid(HeightField field) {
        int levels = 1;
        for (long cells = Math.max(field.rows, field.columns) - 1; cells > 2; cells = (cells + 1) / 2) {
            levels++;
        }
        top = levels - 1;
        rows = new int[levels];
        columns = new int[levels];
        from = new int[levels];
        for (int level = 0; level < levels; level++) {
            rows[level] = blocks(level == 0 ? field.rows - 1 : rows[level - 1]);
            columns[level] = blocks(level == 0 ? field.columns - 1 : columns[level - 1]);
        }
        int size = 2;
        for (int level = top - 1; level >= 0; level--) {
            from[level] = size;
            size += 8 * rows[level + 1] * columns[level + 1];
        }
        data = new float[size];
        for (int at = 0; at < size; at += 2) {
            data[at] = Float.POSITIVE_INFINITY;
            data[at + 1] = Float.NEGATIVE_INFINITY;
        }
        for (int row = 0; row < rows[0]; row++) {
            for (int column = 0; column < columns[0]; column++) {
                survey(field, row, column);
            }
        }
        for (int level = 1; level <= top; level++) {
            for (int row = 0; row < rows[level]; row++) {
                for (int column = 0; column < columns[level]; column++) {
                    unite(level, row, column);
                }
            }
        }
    }

    private static int blocks(int parts) {
        return (parts + 1) / 2;
    }

    private void survey(HeightField field, int row, int column) {
        float least = Float.POSITIVE_INFINITY;
        float greatest = Float.NEGATIVE_INFINITY;
        int end = Math.min(2 * row + 3, field.rows) * field.columns;
        int width = Math.min(3, field.columns - 2 * column);
        for (int line = 2 * row * field.columns + 2 * column; line < end; line += field.columns) {
            for (int at = line; at < line + width; at++) {
                float height = field.heights[at];
                least = height < least ? height : least;
                greatest = height > greatest ? height : greatest;
            }
        }
        int at = block(0, row, column);
        data[at] = least;
        data[at + 1] = greatest;
    }

    private void unite(int level, int row, int column) {
        int children = children(level, row, column);
        int at = block(level, row, column);
        for (int k = children; k < children + 8; k += 2) {
            data[at] = Math.min(data[at], data[k]);
            data[at + 1] = Math.max(data[at + 1], data[k + 1]);
        }
    }

    /** Returns the offset of a block in {@link #data}; 0 for the one at the top. */
    public int block(int level, int row, int column) {
        return level == top ? 0 : children(level + 1, row >> 1, column >> 1) + 4 * (row & 1) + 2 * (column & 1);
    }

    /**
     * Returns the offset in {@link #data} of the four children of a block above level 0: south-west, south-east,
     * north-west, north-east.
     */
    public int children(int level, int row, int column) {
        return from[level - 1] + 8 * (row * columns[level] + column);
    }

    /** Lowest elevation of all posts, metres. */
    public float lowest() {
        return data[0];
    }

    /** Highest elevation of all posts, metres. */
    public float highest() {
        return data[1];
    }
}
