// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/**
 * Elevations of the ground at the posts (samples) of a regular grid, in the grid's own frame: x north by rows, y up, z
 * east by columns. Each cell between four posts is two triangles that share the diagonal from its south-west to its
 * north-east post. Rays, contacts and pictures all use these triangles. A {@link HeightField} holds all posts,
 * {@link HeightTiles} those in use. Any thread.
 */
public abstract class HeightGrid {
    /** Posts from south to north, at least 2. */
    public final int rows;
    /** Posts from west to east, at least 2. */
    public final int columns;
    /** x of the southernmost row, metres. */
    public final double lowX;
    /** z of the westernmost column, metres. */
    public final double lowZ;
    /** Metres from row to row. */
    public final double spacingX;
    /** Metres from column to column. */
    public final double spacingZ;

    HeightGrid(int rows, int columns, double lowX, double lowZ, double spacingX, double spacingZ) {
        if (rows < 2 || columns < 2 || !(spacingX > 0) || !(spacingZ > 0)) {
            throw new IllegalArgumentException("height field: " + rows + " x " + columns + " posts " + spacingX
                + " and " + spacingZ + " m apart, legal: at least 2 x 2 posts, spacings above 0");
        }
        double least = Math.max(closest(lowX, rows, spacingX), closest(lowZ, columns, spacingZ));
        if (!(Math.min(spacingX, spacingZ) >= least)) {
            throw new IllegalArgumentException("height field: posts " + spacingX + " and " + spacingZ
                + " m apart, legal at this distance: " + least + " m or more");
        }
        this.rows = rows;
        this.columns = columns;
        this.lowX = lowX;
        this.lowZ = lowZ;
        this.spacingX = spacingX;
        this.spacingZ = spacingZ;
    }

    /** Returns the smallest spacing at which posts stay distinct as floats, metres. */
    private static double closest(double low, int count, double spacing) {
        return Math.ulp((float) Math.max(Math.abs(low), Math.abs(low + (count - 1) * spacing)));
    }

    /** x of a row, metres: rays, contacts and drawing all use this float. */
    public final float x(int row) {
        return (float) (lowX + row * spacingX);
    }

    /** z of a column, metres, likewise. */
    public final float z(int column) {
        return (float) (lowZ + column * spacingZ);
    }

    /** Returns the row of cells at an x, clamped to the grid. */
    final int row(double x) {
        int row = Math.max(0, Math.min((int) ((x - lowX) / spacingX), rows - 2));
        return row + (row > 0 && x < x(row) ? -1 : row < rows - 2 && x > x(row + 1) ? 1 : 0);
    }

    /** Returns the column of cells at a z, clamped to the grid. */
    final int column(double z) {
        int column = Math.max(0, Math.min((int) ((z - lowZ) / spacingZ), columns - 2));
        return column + (column > 0 && z < z(column) ? -1 : column < columns - 2 && z > z(column + 1) ? 1 : 0);
    }

    /** Whether there is ground at a place. */
    final boolean has(double x, double z) {
        return x >= x(0) && z >= z(0) && x <= x(rows - 1) && z <= z(columns - 1);
    }

    /** Elevation of a post, metres. */
    public abstract float y(int row, int column);

    /** Returns the elevation of the ground, metres; NaN beside the grid. */
    public abstract double height(double x, double z);

    /** Lowest elevation of all posts, metres. */
    public abstract float lowest();

    /** Highest elevation of all posts, metres. */
    public abstract float highest();
}
