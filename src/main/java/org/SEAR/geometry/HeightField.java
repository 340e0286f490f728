package org.SEAR.geometry;

/**
 * Heights of the ground at the posts of a regular grid, in the field's own frame: x north by rows, y up, z east by columns. Each cell between four
 * posts is two triangles that share the diagonal from its south-west to its north-east post; whoever asks where the ground is, beams, contacts and
 * pictures, takes these triangles. Nobody changes the array afterwards. Any thread.
 */
public final class HeightField {
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
    /** Height of each post, metres, row by row from the south, each from the west. */
    public final float[] heights;

    /**
     * @param lowX metres, likewise lowZ
     * @param spacingX metres, likewise spacingZ
     * @param heights rows * columns of them
     */
    public HeightField(int rows, int columns, double lowX, double lowZ, double spacingX, double spacingZ, float[] heights) {
        if (rows < 2 || columns < 2 || heights.length != rows * columns || !(spacingX > 0) || !(spacingZ > 0)) {
            throw new IllegalArgumentException("height field: " + rows + " x " + columns + " posts " + spacingX + " and " + spacingZ
                + " m apart, " + heights.length + " heights; legal: at least 2 x 2 posts, as many heights, spacings above 0");
        }
        this.rows = rows;
        this.columns = columns;
        this.lowX = lowX;
        this.lowZ = lowZ;
        this.spacingX = spacingX;
        this.spacingZ = spacingZ;
        this.heights = heights;
    }

    /** Where a row stands, metres. */
    public double x(int row) {
        return lowX + row * spacingX;
    }

    /** Where a column stands, metres. */
    public double z(int column) {
        return lowZ + column * spacingZ;
    }

    /** Height of a post, metres. */
    public float y(int row, int column) {
        return heights[row * columns + column];
    }

    /** Height of the ground, metres; NaN beside the field. */
    public double height(double x, double z) {
        double along = (x - lowX) / spacingX;
        double across = (z - lowZ) / spacingZ;
        if (!(along >= 0 && across >= 0 && along <= rows - 1 && across <= columns - 1)) {
            return Double.NaN;
        }
        int row = Math.min((int) along, rows - 2);
        int column = Math.min((int) across, columns - 2);
        double u = along - row;
        double v = across - column;
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
