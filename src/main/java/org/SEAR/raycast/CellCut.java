// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import org.SEAR.geometry.HeightField;

/**
 * Lines in which a fan's plane cuts the triangles of four by four cells of a {@link HeightField}. The posts below the
 * plane determine which edges it crosses. Two crossed edges of a triangle form a line, which the rays between its ends
 * hit. One thread.
 */
final class CellCut {
    /** Cells per side. */
    static final int CELLS = 4;
    private static final int WIDTH = CELLS + 1;
    /** Posts are numbered by row times this value plus column. */
    private static final int ROW = 8;
    private static final int POSTS = ROW * WIDTH;
    /** South-western posts of cells, one bit each. */
    private static final long CORNERS = 0x0f0f0f0fL;
    /** Posts where an eastward edge starts, and a northward one. */
    private static final long EASTWARD = 0x0f0f0f0f0fL;
    private static final long NORTHWARD = 0x1f1f1f1fL;
    /** Edges are numbered by their start post: eastward, then northward and diagonal from these numbers on. */
    private static final int NORTH = POSTS;
    private static final int DIAGONAL = 2 * POSTS;

    private final DepthBuffer depth;
    private final TriangleCut triangles;
    private final PlaneCut plane;
    /** Positions of rows and columns of posts, and column offsets in the field. */
    private final double[] souths = new double[WIDTH];
    private final double[] wests = new double[WIDTH];
    private final int[] offsets = new int[WIDTH];
    /** Height of each post, and its height above the plane. */
    private final double[] ups = new double[POSTS];
    private final double[] above = new double[POSTS];
    /** Crossing point of each crossed edge in the fan's frame, and the first ray at or to the left of it. */
    private final double[] xs = new double[3 * POSTS];
    private final double[] zs = new double[3 * POSTS];
    private final int[] beams = new int[3 * POSTS];
    private final float[] corners = new float[9];

    CellCut(DepthBuffer depth, TriangleCut triangles) {
        this.depth = depth;
        this.triangles = triangles;
        plane = triangles.plane;
    }

    /**
     * Intersects the cells from a south-western post on with a range of rays.
     * @param first first ray that may hit the cells, likewise last; the rays are less than half a turn apart and the
     *     cells lie ahead of them
     * @return number of triangles that the plane cuts
     */
    int intersect(HeightField heights, int row, int column, int first, int last) {
        long under = posts(heights, row, column);
        long east = (under ^ under >> 1) & EASTWARD;
        long north = (under ^ under >> ROW) & NORTHWARD;
        long diagonal = (under ^ under >> ROW + 1) & CORNERS;
        if ((east | north | diagonal) == 0) {
            return 0;
        }
        cross(under, east, 0, 1, first, last);
        cross(under, north, NORTH, ROW, first, last);
        cross(under, diagonal, DIAGONAL, ROW + 1, first, last);
        long southEastern = (east | diagonal) & CORNERS;
        for (long posts = southEastern; posts != 0; posts &= posts - 1) {
            int post = Long.numberOfTrailingZeros(posts);
            line(post, NORTH + post + 1, DIAGONAL + post, east >> post & 1, diagonal >> post & 1);
        }
        long northWestern = (north | diagonal) & CORNERS;
        for (long posts = northWestern; posts != 0; posts &= posts - 1) {
            int post = Long.numberOfTrailingZeros(posts);
            line(NORTH + post, post + ROW, DIAGONAL + post, north >> post & 1, diagonal >> post & 1);
        }
        return Long.bitCount(southEastern) + Long.bitCount(northWestern);
    }

    /**
     * As {@link #intersect}, but for all rays and any position of the fan's origin. Returns the number of triangles
     * tested.
     */
    int intersectAll(HeightField heights, int row, int column) {
        int endRow = Math.min(row + CELLS, heights.rows - 1);
        int endColumn = Math.min(column + CELLS, heights.columns - 1);
        for (int r = row; r < endRow; r++) {
            for (int c = column; c < endColumn; c++) {
                heights.triangle(r, c, 0, corners);
                triangles.triangle(corners, 0);
                heights.triangle(r, c, 1, corners);
                triangles.triangle(corners, 0);
            }
        }
        return 2 * (endRow - row) * (endColumn - column);
    }

    /**
     * Computes the posts' heights and returns a bit for each post below the plane. Cells outside the field collapse to
     * zero area.
     */
    private long posts(HeightField heights, int row, int column) {
        int end = heights.columns - 1 - column;
        for (int c = 0; c < WIDTH; c++) {
            offsets[c] = Math.min(c, end);
            wests[c] = heights.z(column + offsets[c]);
        }
        long under = 0;
        for (int r = 0; r < WIDTH; r++) {
            int line = Math.min(row + r, heights.rows - 1);
            souths[r] = heights.x(line);
            under |= row(heights.heights, line * heights.columns + column, r) << ROW * r;
        }
        return under;
    }

    private long row(float[] heights, int from, int row) {
        int under = 0;
        for (int c = 0; c < WIDTH; c++) {
            double y = heights[from + offsets[c]];
            double height = plane.height(souths[row], y, wests[c]);
            ups[ROW * row + c] = y;
            above[ROW * row + c] = height;
            under |= FanDirections.negative(height + 0.0) << c;
        }
        return under;
    }

    /** Computes the crossing points of edges, identical for both triangles of an edge, and the first ray of each. */
    private void cross(long under, long edges, int number, int step, int first, int last) {
        for (long from = edges; from != 0; from &= from - 1) {
            int post = Long.numberOfTrailingZeros(from);
            int down = post + (step & (int) (under >> post & 1) - 1);
            int up = post + post + step - down;
            double share = above[up] / (above[up] - above[down]);
            double south = souths[up / ROW];
            double west = wests[up % ROW];
            double otherSouth = souths[down / ROW];
            double otherWest = wests[down % ROW];
            double left = plane.x(south, ups[up], west);
            double ahead = plane.z(south, ups[up], west);
            double x = left + (plane.x(otherSouth, ups[down], otherWest) - left) * share;
            double z = ahead + (plane.z(otherSouth, ups[down], otherWest) - ahead) * share;
            xs[number + post] = x;
            zs[number + post] = z;
            beams[number + post] = depth.beams.first(x, z, first, last);
        }
    }

    /** Draws the line between a triangle's two crossed edges, given its outer edges and its diagonal. */
    private void line(int outer, int other, int diagonal, long outerCrossed, long diagonalCrossed) {
        int one = outerCrossed == 1 ? outer : diagonal;
        int two = (outerCrossed & diagonalCrossed) == 1 ? diagonal : other;
        if (beams[one] == beams[two]) {
            return;
        }
        double turn = zs[one] * xs[two] - xs[one] * zs[two];
        double a = -(zs[two] - zs[one]) / turn;
        double b = (xs[two] - xs[one]) / turn;
        if (turn > 0) {
            depth.fill(beams[one], beams[two], a, b, triangles.shape());
        } else if (turn < 0) {
            depth.fill(beams[two], beams[one], a, b, triangles.shape());
        }
    }
}
