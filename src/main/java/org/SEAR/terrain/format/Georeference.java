// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.util.Objects;

/**
 * Position of a map's posts: map coordinates (degrees east and north, or metres or feet of a projection) as an affine
 * function of column and row. A post is the centre of its pixel, even if the file refers to pixel corners. Immutable,
 * any thread.
 */
public final class Georeference {
    /** WGS 84, longitude and latitude in degrees. */
    public static final String WGS84 = "EPSG:4326";

    /** Coordinate system: EPSG:NUMBER or PROJ parameters; null if unknown. */
    public final String system;
    /** Map coordinates of the post in column 0 and row 0. */
    public final double x0;
    public final double y0;
    /** Change of x from column to column. */
    public final double xColumn;
    /** Change of y from column to column. */
    public final double yColumn;
    /** Change of x from row to row. */
    public final double xRow;
    /** Change of y from row to row. */
    public final double yRow;
    private final double determinant;

    /**
     * @param system EPSG:NUMBER, PROJ parameters, or null
     * @param x0 map coordinates of the first post, likewise y0
     * @param xColumn change of x from column to column; yColumn of y; xRow of x from row to row; yRow of y
     */
    public Georeference(String system, double x0, double y0, double xColumn, double yColumn, double xRow, double yRow) {
        this.system = system;
        this.x0 = x0;
        this.y0 = y0;
        this.xColumn = xColumn;
        this.yColumn = yColumn;
        this.xRow = xRow;
        this.yRow = yRow;
        this.determinant = xColumn * yRow - yColumn * xRow;
    }

    /** Returns whether all numbers are finite and rows and columns are not parallel. */
    public boolean isRegular() {
        return Double.isFinite(x0) && Double.isFinite(y0) && Double.isFinite(determinant)
            && Math.abs(determinant) > 1e-24;
    }

    public double x(double column, double row) {
        return x0 + xColumn * column + xRow * row;
    }

    public double y(double column, double row) {
        return y0 + yColumn * column + yRow * row;
    }

    /** Returns the fractional column at map coordinates. */
    public double column(double x, double y) {
        return ((x - x0) * yRow - (y - y0) * xRow) / determinant;
    }

    /** Returns the fractional row at map coordinates. */
    public double row(double x, double y) {
        return ((y - y0) * xColumn - (x - x0) * yColumn) / determinant;
    }

    /** Returns the same grid with another post as its first. */
    public Georeference from(double column, double row) {
        return new Georeference(system, x(column, row), y(column, row), xColumn, yColumn, xRow, yRow);
    }

    /** Returns the grid shifted by (x, y) map units. */
    public Georeference moved(double x, double y) {
        return new Georeference(system, x0 + x, y0 + y, xColumn, yColumn, xRow, yRow);
    }

    /** Returns the same numbers in another coordinate system. */
    public Georeference in(String other) {
        return new Georeference(other, x0, y0, xColumn, yColumn, xRow, yRow);
    }

    /** Returns the distance between columns, map units. */
    public double columnSpacing() {
        return Math.hypot(xColumn, yColumn);
    }

    /** Returns the distance between rows, map units. */
    public double rowSpacing() {
        return Math.hypot(xRow, yRow);
    }

    /**
     * Returns whether another grid's rows and columns coincide with this grid's, within 0.01 cells over the given size.
     */
    public boolean isAligned(Georeference other, int columns, int rows) {
        return Objects.equals(system, other.system) && isWhole(column(other.x0, other.y0))
            && isWhole(row(other.x0, other.y0))
            && near(column(other.x(columns, rows), other.y(columns, rows)) - column(other.x0, other.y0), columns)
            && near(row(other.x(columns, rows), other.y(columns, rows)) - row(other.x0, other.y0), rows)
            && near(column(other.x(columns, 0), other.y(columns, 0)) - column(other.x0, other.y0), columns);
    }

    private static boolean isWhole(double value) {
        return near(value, Math.rint(value));
    }

    private static boolean near(double a, double b) {
        return Math.abs(a - b) < 0.01;
    }
}
