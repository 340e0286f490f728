// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;

/** A chessboard for camera calibration, with a white margin of one square's width. */
@Described("a vertical plate with a chessboard for camera calibration, its front towards -z; its origin is the middle "
    + "of the board")
public class Chessboard extends Board {
    /** Largest number of squares in a row or column. */
    private static final int MOST = 60;

    @Param(doc = "squares in a row; OpenCV counts the inner corners, one less", min = 3, max = MOST)
    private int columns = 10;
    @Param(doc = "squares in a column", min = 3, max = MOST)
    private int rows = 7;
    @Param(doc = "side of a square", unit = "m", min = SMALL, max = 100, required = true, initial = "0.03")
    private double square;

    /** For reading from a file. */
    protected Chessboard() {
    }

    /**
     * Fixed in place.
     *
     * @param columns squares in a row, 3 to 60
     * @param rows squares in a column, 3 to 60
     * @param square side of a square, metres
     */
    public Chessboard(String name, int columns, int rows, double square) {
        this(name, columns, rows, square, 0, 0, 0, 0, 0, 0);
    }

    /** With its middle at (x, y, z), metres. */
    public Chessboard(String name, int columns, int rows, double square, double x, double y, double z) {
        this(name, columns, rows, square, x, y, z, 0, 0, 0);
    }

    /** With its middle at (x, y, z), metres, turned by (rx, ry, rz), degrees. */
    public Chessboard(String name, int columns, int rows, double square, double x, double y, double z, double rx,
        double ry, double rz) {
        super(name, 0);
        this.columns = columns;
        this.rows = rows;
        this.square = square;
        pose(x, y, z, rx, ry, rz);
        created(Chessboard.class);
    }

    public int getColumns() {
        return columns;
    }

    public int getRows() {
        return rows;
    }

    public double getSquare() {
        return square;
    }

    @Override
    public double getBoardWidth() {
        return (columns + 2) * square;
    }

    @Override
    public double getBoardHeight() {
        return (rows + 2) * square;
    }

    @Override
    public String getPicture() {
        return "made/chessboard/" + columns + 'x' + rows + ".png";
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (getImage() != null) {
            faults.add("image", getImage(), "none: a chessboard has the picture of its squares");
        }
    }
}
