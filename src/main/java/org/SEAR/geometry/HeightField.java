// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/** {@link HeightGrid} entirely in memory. The array never changes. Any thread. */
public final class HeightField extends HeightGrid {
    /** Elevation of each post, metres, row by row from the south, each from the west. */
    public final float[] heights;
    private volatile HeightPyramid pyramid;

    /**
     * @param lowX metres, likewise lowZ
     * @param spacingX metres, likewise spacingZ
     * @param heights rows * columns of them
     */
    public HeightField(int rows, int columns, double lowX, double lowZ, double spacingX, double spacingZ,
        float[] heights) {
        super(rows, columns, lowX, lowZ, spacingX, spacingZ);
        if (heights.length != rows * columns) {
            throw new IllegalArgumentException("height field: " + rows + " x " + columns + " posts, " + heights.length
                + " heights, legal: as many heights");
        }
        this.heights = heights;
    }

    @Override
    public float y(int row, int column) {
        return heights[row * columns + column];
    }

    /**
     * Copies the corners of a triangle, counter-clockwise seen from above.
     * @param row of the cell's south-western post, likewise column
     * @param half 0: the triangle south-east of the diagonal, 1: the one north-west of it
     * @param into takes x, y and z of the three corners
     */
    public void triangle(int row, int column, int half, float[] into) {
        int at = row * columns + column;
        float south = x(row);
        float north = x(row + 1);
        float west = z(column);
        float east = z(column + 1);
        into[0] = south;
        into[1] = heights[at];
        into[2] = west;
        if (half == 0) {
            into[3] = south;
            into[4] = heights[at + 1];
            into[5] = east;
            into[6] = north;
            into[7] = heights[at + columns + 1];
            into[8] = east;
        } else {
            into[3] = north;
            into[4] = heights[at + columns + 1];
            into[5] = east;
            into[6] = north;
            into[7] = heights[at + columns];
            into[8] = west;
        }
    }

    /** Returns the lowest and highest elevations of its blocks; made at the first call. */
    public HeightPyramid getPyramid() {
        return pyramid != null ? pyramid : makePyramid();
    }

    private synchronized HeightPyramid makePyramid() {
        if (pyramid == null) {
            pyramid = new HeightPyramid(this);
        }
        return pyramid;
    }

    @Override
    public float lowest() {
        return getPyramid().lowest();
    }

    @Override
    public float highest() {
        return getPyramid().highest();
    }

    @Override
    public double height(double x, double z) {
        if (!has(x, z)) {
            return Double.NaN;
        }
        int row = row(x);
        int column = column(z);
        double u = (x - x(row)) / ((double) x(row + 1) - x(row));
        double v = (z - z(column)) / ((double) z(column + 1) - z(column));
        int at = row * columns + column;
        double southWest = heights[at];
        double northEast = heights[at + columns + 1];
        if (v >= u) {
            double southEast = heights[at + 1];
            return southWest + v * (southEast - southWest) + u * (northEast - southEast);
        }
        double northWest = heights[at + columns];
        return southWest + u * (northWest - southWest) + v * (northEast - northWest);
    }
}
