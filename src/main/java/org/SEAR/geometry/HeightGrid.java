package org.SEAR.geometry;

/**
 * Heights of the ground at the posts of a regular grid, in the grid's own frame: x north by rows, y up, z east by columns. Each cell between four
 * posts is two triangles that share the diagonal from its south-west to its north-east post; whoever asks where the ground is, beams, contacts and
 * pictures, takes these triangles. A {@link HeightField} holds all of them, {@link HeightTiles} those that are in use. Any thread.
 */
public abstract class HeightGrid {
    /** Posts from south to north, at least 2. */
    public final int rows;
    /** Posts from west to east, at least 2. */
    public final int columns;
    /** Where the southernmost row stands, metres. */
    public final double lowX;
    /** Where the westernmost column stands, metres. */
    public final double lowZ;
    /** Metres from row to row. */
    public final double spacingX;
    /** Metres from column to column. */
    public final double spacingZ;

    HeightGrid(int rows, int columns, double lowX, double lowZ, double spacingX, double spacingZ) {
        if (rows < 2 || columns < 2 || !(spacingX > 0) || !(spacingZ > 0)) {
            throw new IllegalArgumentException("height field: " + rows + " x " + columns + " posts " + spacingX + " and " + spacingZ
                + " m apart, legal: at least 2 x 2 posts, spacings above 0");
        }
        double least = Math.max(closest(lowX, rows, spacingX), closest(lowZ, columns, spacingZ));
        if (!(Math.min(spacingX, spacingZ) >= least)) {
            throw new IllegalArgumentException("height field: posts " + spacingX + " and " + spacingZ + " m apart, legal so far out: " + least
                + " m or more");
        }
        this.rows = rows;
        this.columns = columns;
        this.lowX = lowX;
        this.lowZ = lowZ;
        this.spacingX = spacingX;
        this.spacingZ = spacingZ;
    }

    /** How close posts may stand so that each has a place of its own, metres. */
    private static double closest(double low, int count, double spacing) {
        return Math.ulp((float) Math.max(Math.abs(low), Math.abs(low + (count - 1) * spacing)));
    }

    /** Where a row stands, metres: this float is its x for everything that meets, touches or draws the ground. */
    public final float x(int row) {
        return (float) (lowX + row * spacingX);
    }

    /** Where a column stands, metres, likewise. */
    public final float z(int column) {
        return (float) (lowZ + column * spacingZ);
    }

    /** The row of cells in which a place lies, the nearest one beside the grid. */
    final int row(double x) {
        int row = Math.max(0, Math.min((int) ((x - lowX) / spacingX), rows - 2));
        return row + (row > 0 && x < x(row) ? -1 : row < rows - 2 && x > x(row + 1) ? 1 : 0);
    }

    /** The column of cells in which a place lies, likewise. */
    final int column(double z) {
        int column = Math.max(0, Math.min((int) ((z - lowZ) / spacingZ), columns - 2));
        return column + (column > 0 && z < z(column) ? -1 : column < columns - 2 && z > z(column + 1) ? 1 : 0);
    }

    /** Whether there is ground at a place. */
    final boolean has(double x, double z) {
        return x >= x(0) && z >= z(0) && x <= x(rows - 1) && z <= z(columns - 1);
    }

    /** Height of a post, metres. */
    public abstract float y(int row, int column);

    /** Height of the ground, metres; NaN beside the grid. */
    public abstract double height(double x, double z);

    /** The least height of all, metres. */
    public abstract float lowest();

    /** The greatest height of all, metres. */
    public abstract float highest();
}
