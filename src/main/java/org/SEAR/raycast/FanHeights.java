package org.SEAR.raycast;

import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightPyramid;

/**
 * Cuts a {@link HeightField} with a fan's plane: walks the blocks of its pyramid that the plane meets, nearer ones first, as far as some beam can
 * still see into the ball around the block's part of the plane. One thread.
 */
final class FanHeights {
    /** Relative error of the plane's functions, many times over. */
    private static final double ROUNDING = 1e-13;
    /** Four blocks of each level at most. */
    private static final int DEPTH = 4 * Integer.SIZE;

    private final DepthBuffer depth;
    private final TriangleCut triangles;
    private final PlaneCut plane;
    private final int[] levels = new int[DEPTH];
    private final int[] rows = new int[DEPTH];
    private final int[] columns = new int[DEPTH];
    /** Of each block: the middle of its part of the plane in the fan's frame, and how far it reaches around it. */
    private final double[] xs = new double[DEPTH];
    private final double[] zs = new double[DEPTH];
    private final double[] radii = new double[DEPTH];
    private int size;
    private final float[] corners = new float[9];
    private HeightField field;
    private float[] data;
    private double range;
    /** How much the heights within a block spread its part of the plane: 0 for a level fan. */
    private double tilt;
    private double slackX;
    private double slackZ;
    private double slack;
    /** Where the fan starts, as the nearest parts of blocks are found by it. */
    private double originX;
    private double originZ;
    private final double[] above = new double[9];

    FanHeights(DepthBuffer depth, TriangleCut triangles) {
        this.depth = depth;
        this.triangles = triangles;
        plane = triangles.plane;
    }

    /**
     * Meets the field; the triangles have been started.
     *
     * @param originOfX of the fan in the field's frame, likewise originOfZ
     * @param work counts it
     */
    void cast(HeightField heights, double originOfX, double originOfZ, double maxRange, RayCaster work) {
        field = heights;
        originX = originOfX;
        originZ = originOfZ;
        range = maxRange;
        HeightPyramid pyramid = heights.getPyramid();
        data = pyramid.data;
        tilt = Math.sqrt(plane.xb * plane.xb + plane.zb * plane.zb);
        double farX = Math.max(Math.abs(heights.x(0)), Math.abs(heights.x(heights.rows - 1)));
        double farZ = Math.max(Math.abs(heights.z(0)), Math.abs(heights.z(heights.columns - 1)));
        slackX = Math.ulp((float) farX);
        slackZ = Math.ulp((float) farZ);
        slack = ROUNDING * (farX + farZ + Math.max(Math.abs(data[0]), Math.abs(data[1])) + Math.abs(plane.hd) + Math.abs(plane.xd)
            + Math.abs(plane.zd));
        size = 0;
        push(pyramid.top, 0, 0, 0);
        while (size > 0) {
            size--;
            if (depth.sees(xs[size], zs[size], radii[size])) {
                work.fanNodes++;
                if (levels[size] == 0) {
                    cells(rows[size], columns[size], work);
                } else {
                    open(pyramid, levels[size], rows[size], columns[size]);
                }
            }
        }
    }

    /** Adds the four parts of a block, the nearest last. */
    private void open(HeightPyramid pyramid, int level, int row, int column) {
        int at = pyramid.children(level, row, column);
        int north = originX >= field.lowX + (2 * row + 1) * (1 << level) * field.spacingX ? 1 : 0;
        int east = originZ >= field.lowZ + (2 * column + 1) * (1 << level) * field.spacingZ ? 1 : 0;
        int r = 2 * row;
        int c = 2 * column;
        push(level - 1, r + 1 - north, c + 1 - east, at + 4 * (1 - north) + 2 * (1 - east));
        push(level - 1, r + 1 - north, c + east, at + 4 * (1 - north) + 2 * east);
        push(level - 1, r + north, c + 1 - east, at + 4 * north + 2 * (1 - east));
        push(level - 1, r + north, c + east, at + 4 * north + 2 * east);
    }

    /** Keeps a block for later, if the plane meets it within the range. */
    private void push(int level, int row, int column, int at) {
        double half = 1 << level;
        double x = field.lowX + (2 * row + 1) * half * field.spacingX;
        double z = field.lowZ + (2 * column + 1) * half * field.spacingZ;
        double y = ((double) data[at] + data[at + 1]) / 2;
        double reachX = half * field.spacingX + slackX;
        double reachY = ((double) data[at + 1] - data[at]) / 2;
        double reachZ = half * field.spacingZ + slackZ;
        double height = plane.height(x, y, z);
        if (!(Math.abs(height) <= Math.abs(plane.ha) * reachX + Math.abs(plane.hb) * reachY + Math.abs(plane.hc) * reachZ + slack)) {
            return;
        }
        double left = plane.x(x, y, z);
        double ahead = plane.z(x, y, z);
        double radius = Math.sqrt(reachX * reachX + reachZ * reachZ) + tilt * reachY + slack;
        if (left * left + ahead * ahead > (range + radius) * (range + radius)) {
            return;
        }
        levels[size] = level;
        rows[size] = row;
        columns[size] = column;
        xs[size] = left;
        zs[size] = ahead;
        radii[size++] = radius;
    }

    /** The cells of a block of the lowest level. */
    private void cells(int blockRow, int blockColumn, RayCaster work) {
        int firstRow = 2 * blockRow;
        int firstColumn = 2 * blockColumn;
        int endRow = Math.min(firstRow + 2, field.rows - 1);
        int endColumn = Math.min(firstColumn + 2, field.columns - 1);
        for (int row = firstRow; row <= endRow; row++) {
            double x = field.x(row);
            int post = row * field.columns;
            for (int column = firstColumn; column <= endColumn; column++) {
                above[3 * (row - firstRow) + column - firstColumn] = plane.height(x, field.heights[post + column], field.z(column));
            }
        }
        for (int row = firstRow; row < endRow; row++) {
            for (int column = firstColumn; column < endColumn; column++) {
                int at = 3 * (row - firstRow) + column - firstColumn;
                boolean up = above[at] >= 0;
                if (up != above[at + 1] >= 0 || up != above[at + 3] >= 0 || up != above[at + 4] >= 0) {
                    work.triangles += 2;
                    field.triangle(row, column, 0, corners);
                    triangles.triangle(corners, 0);
                    field.triangle(row, column, 1, corners);
                    triangles.triangle(corners, 0);
                }
            }
        }
    }
}
