package org.SEAR.raycast;

import org.SEAR.geometry.HeightField;

/** The lines in which a fan's plane cuts the triangles of two by two cells of a {@link HeightField}. One thread. */
final class CellCut {
    /** Posts in a row. */
    private static final int WIDTH = 3;
    /** Up to so many beams are asked one by one. */
    private static final int FEW = 24;

    private final DepthBuffer depth;
    private final TriangleCut triangles;
    private final PlaneCut plane;
    /** Of the posts: height above the plane, and place in the fan's frame. */
    private final double[] above = new double[WIDTH * WIDTH];
    private final double[] left = new double[WIDTH * WIDTH];
    private final double[] ahead = new double[WIDTH * WIDTH];
    private final float[] corners = new float[9];
    private HeightField field;
    private int first;
    private int last;
    private int looked;
    /** Where the plane crosses an edge. */
    private double x;
    private double z;

    CellCut(DepthBuffer depth, TriangleCut triangles) {
        this.depth = depth;
        this.triangles = triangles;
        plane = triangles.plane;
    }

    /**
     * Looks at the cells from a south-western post on.
     *
     * @param from the first beam that may see them, likewise to
     * @return how many triangles there were to look at
     */
    int meet(HeightField heights, int row, int column, int from, int to) {
        field = heights;
        first = from;
        last = to;
        looked = 0;
        int rows = Math.min(WIDTH, heights.rows - row);
        int columns = Math.min(WIDTH, heights.columns - column);
        for (int r = 0; r < rows; r++) {
            double south = heights.x(row + r);
            int post = (row + r) * heights.columns + column;
            for (int c = 0; c < columns; c++) {
                double up = heights.heights[post + c];
                double west = heights.z(column + c);
                above[WIDTH * r + c] = plane.height(south, up, west);
                left[WIDTH * r + c] = plane.x(south, up, west);
                ahead[WIDTH * r + c] = plane.z(south, up, west);
            }
        }
        for (int r = 0; r < rows - 1; r++) {
            for (int c = 0; c < columns - 1; c++) {
                cell(row + r, column + c, WIDTH * r + c);
            }
        }
        return looked;
    }

    private void cell(int row, int column, int southWest) {
        int southEast = southWest + 1;
        int northWest = southWest + WIDTH;
        int northEast = northWest + 1;
        boolean up = above[southWest] >= 0;
        boolean lone = above[southEast] >= 0 != up;
        boolean otherLone = above[northWest] >= 0 != up;
        if (above[northEast] >= 0 != up) {
            cross(southWest, northEast);
            double middleX = x;
            double middleZ = z;
            cross(southEast, lone ? southWest : northEast);
            segment(middleX, middleZ, row, column, 0);
            cross(northWest, otherLone ? southWest : northEast);
            segment(middleX, middleZ, row, column, 1);
            return;
        }
        if (lone) {
            cross(southWest, southEast);
            double fromX = x;
            double fromZ = z;
            cross(southEast, northEast);
            segment(fromX, fromZ, row, column, 0);
        }
        if (otherLone) {
            cross(southWest, northWest);
            double fromX = x;
            double fromZ = z;
            cross(northWest, northEast);
            segment(fromX, fromZ, row, column, 1);
        }
    }

    /** Where the plane crosses the edge between two posts, one above and one below it; the same for both triangles that share it. */
    private void cross(int one, int other) {
        int up = above[one] >= 0 ? one : other;
        int down = one + other - up;
        double share = above[up] / (above[up] - above[down]);
        x = left[up] + (left[down] - left[up]) * share;
        z = ahead[up] + (ahead[down] - ahead[up]) * share;
    }

    /** The line from a point to where the last edge was crossed, in one triangle of a cell. */
    private void segment(double px, double pz, int row, int column, int half) {
        looked++;
        double turn = pz * x - px * z;
        double ex = x - px;
        double ez = z - pz;
        if (Math.abs(turn) <= TriangleCut.TOUCHING * (Math.abs(ex) + Math.abs(ez))) {
            field.triangle(row, column, half, corners);
            triangles.triangle(corners, 0);
            return;
        }
        double a = -ez / turn;
        double b = ex / turn;
        if (last - first > FEW) {
            triangles.line(px, pz, x, z, turn, a, b);
        } else if (turn > 0) {
            depth.line(px, pz, x, z, a, b, triangles.shape(), first, last);
        } else {
            depth.line(x, z, px, pz, a, b, triangles.shape(), first, last);
        }
    }
}
