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
    private volatile HeightPyramid pyramid;

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
        this.heights = heights;
    }

    /** How close posts may stand so that each has a place of its own, metres. */
    private static double closest(double low, int count, double spacing) {
        return Math.ulp((float) Math.max(Math.abs(low), Math.abs(low + (count - 1) * spacing)));
    }

    /** Where a row stands, metres: this float is its x for everything that meets, touches or draws the ground. */
    public float x(int row) {
        return (float) (lowX + row * spacingX);
    }

    /** Where a column stands, metres, likewise. */
    public float z(int column) {
        return (float) (lowZ + column * spacingZ);
    }

    /** Height of a post, metres. */
    public float y(int row, int column) {
        return heights[row * columns + column];
    }

    /**
     * The corners of a triangle, counter-clockwise seen from above.
     *
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

    /** The least and greatest heights of its blocks; made when it is asked for the first time. */
    public HeightPyramid getPyramid() {
        return pyramid != null ? pyramid : makePyramid();
    }

    private synchronized HeightPyramid makePyramid() {
        if (pyramid == null) {
            pyramid = new HeightPyramid(this);
        }
        return pyramid;
    }

    /** Height of the ground, metres; NaN beside the field. */
    public double height(double x, double z) {
        if (!(x >= x(0) && z >= z(0) && x <= x(rows - 1) && z <= z(columns - 1))) {
            return Double.NaN;
        }
        int row = Math.max(0, Math.min((int) ((x - lowX) / spacingX), rows - 2));
        row += row > 0 && x < x(row) ? -1 : row < rows - 2 && x > x(row + 1) ? 1 : 0;
        int column = Math.max(0, Math.min((int) ((z - lowZ) / spacingZ), columns - 2));
        column += column > 0 && z < z(column) ? -1 : column < columns - 2 && z > z(column + 1) ? 1 : 0;
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
