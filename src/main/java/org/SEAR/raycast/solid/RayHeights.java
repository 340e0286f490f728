package org.SEAR.raycast.solid;

import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightPyramid;

/**
 * Leads one beam over a {@link HeightField}, through the blocks of its pyramid, nearer ones first, to the cells whose triangles it may meet. Blocks
 * are taken a little larger than they are, by more than the rounding of the tests, so that no cell is left out that the beam touches. One thread.
 */
public final class RayHeights {
    /** Stands for 1 / 0. */
    private static final double LARGEST = 1e30;
    /** More than the rounding of a place on the beam, relative to how far out the field and the origin are. */
    private static final double ROUNDING = 1e-12;
    /** Four blocks of each level at most. */
    private static final int DEPTH = 4 * Integer.SIZE;

    /** Blocks looked at since the beginning. */
    public long nodes;
    /** Triangles looked at. */
    public long triangles;

    private final int[] levels = new int[DEPTH];
    private final int[] rows = new int[DEPTH];
    private final int[] columns = new int[DEPTH];
    private final double[] ins = new double[DEPTH];
    private final double[] outs = new double[DEPTH];
    private int depth;
    private final float[] corners = new float[9];
    private HeightField field;
    private float[] data;
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;
    private double ix;
    private double iz;
    /** 1 where the beam goes south, or west: there the far side of a cell is met first. */
    private int south;
    private int west;
    private double slackX;
    private double slackY;
    private double slackZ;
    private double best;
    private double limit;
    /** The triangle that the last successful {@link #meet} met: twice the number of its south-western post, plus 1 west of the diagonal. */
    private long triangle;

    /** The distance to the nearest triangle up to a distance, both in units of the direction's length; the first of two that are equally near. */
    public double meet(HeightField heights, double px, double py, double pz, double vx, double vy, double vz, double maxRange) {
        field = heights;
        HeightPyramid pyramid = heights.getPyramid();
        data = pyramid.data;
        ox = px;
        oy = py;
        oz = pz;
        dx = vx;
        dy = vy;
        dz = vz;
        ix = inverse(vx);
        iz = inverse(vz);
        south = ix < 0 ? 1 : 0;
        west = iz < 0 ? 1 : 0;
        double farX = Math.max(Math.abs(heights.x(0)), Math.abs(heights.x(heights.rows - 1)));
        double farZ = Math.max(Math.abs(heights.z(0)), Math.abs(heights.z(heights.columns - 1)));
        slackX = Math.ulp((float) farX) + ROUNDING * Math.abs(ox);
        slackZ = Math.ulp((float) farZ) + ROUNDING * Math.abs(oz);
        slackY = ROUNDING * (Math.max(Math.abs(data[0]), Math.abs(data[1])) + Math.abs(oy) + Math.abs(ox) + Math.abs(oz) + farX + farZ);
        best = Double.POSITIVE_INFINITY;
        limit = maxRange;
        depth = 0;
        push(pyramid.top, 0, 0, 0, 0, maxRange);
        while (depth > 0) {
            depth--;
            nodes++;
            if (ins[depth] > limit) {
                continue;
            }
            if (levels[depth] == 0) {
                cells(rows[depth], columns[depth], ins[depth], outs[depth]);
            } else {
                open(pyramid, levels[depth], rows[depth], columns[depth], ins[depth], outs[depth]);
            }
        }
        return best;
    }

    private static double inverse(double d) {
        return Math.abs(d) < 1 / LARGEST ? Math.copySign(LARGEST, d) : 1 / d;
    }

    /** Keeps a block for later, if the part of the beam over it comes between its least and greatest height. */
    private void push(int level, int row, int column, int at, double in, double out) {
        double from = oy + in * dy;
        double to = oy + out * dy;
        if (in <= out && Math.max(from, to) >= data[at] - slackY && Math.min(from, to) <= data[at + 1] + slackY) {
            levels[depth] = level;
            rows[depth] = row;
            columns[depth] = column;
            ins[depth] = in;
            outs[depth++] = out;
        }
    }

    /** Adds the four parts of a block, those last that the beam comes to first. */
    private void open(HeightPyramid pyramid, int level, int row, int column, double in, double out) {
        int size = 1 << level;
        double x = field.lowX + (2 * row + 1) * size * field.spacingX - ox;
        double z = field.lowZ + (2 * column + 1) * size * field.spacingZ - oz;
        double last = Math.min(out, limit);
        double nearX = (x + (south == 0 ? slackX : -slackX)) * ix;
        double farX = (x - (south == 0 ? slackX : -slackX)) * ix;
        double nearZ = (z + (west == 0 ? slackZ : -slackZ)) * iz;
        double farZ = (z - (west == 0 ? slackZ : -slackZ)) * iz;
        int at = pyramid.children(level, row, column);
        int r = 2 * row;
        int c = 2 * column;
        int lateRow = 1 - south;
        int lateColumn = 1 - west;
        double inFar = Math.max(in, farX);
        double outNear = Math.min(last, nearX);
        push(level - 1, r + lateRow, c + lateColumn, at + 4 * lateRow + 2 * lateColumn, Math.max(inFar, farZ), last);
        push(level - 1, r + lateRow, c + west, at + 4 * lateRow + 2 * west, inFar, Math.min(last, nearZ));
        push(level - 1, r + south, c + lateColumn, at + 4 * south + 2 * lateColumn, Math.max(in, farZ), outNear);
        push(level - 1, r + south, c + west, at + 4 * south + 2 * west, in, Math.min(outNear, nearZ));
    }

    /** The cells of a block of the lowest level. */
    private void cells(int blockRow, int blockColumn, double in, double out) {
        int endRow = Math.min(2 * blockRow + 2, field.rows - 1);
        int endColumn = Math.min(2 * blockColumn + 2, field.columns - 1);
        for (int row = 2 * blockRow; row < endRow; row++) {
            double low = (field.x(row + south) - ox + (south == 0 ? -slackX : slackX)) * ix;
            double high = (field.x(row + 1 - south) - ox + (south == 0 ? slackX : -slackX)) * ix;
            double inRow = Math.max(in, low);
            double outRow = Math.min(out, high);
            for (int column = 2 * blockColumn; inRow <= outRow && column < endColumn; column++) {
                low = (field.z(column + west) - oz + (west == 0 ? -slackZ : slackZ)) * iz;
                high = (field.z(column + 1 - west) - oz + (west == 0 ? slackZ : -slackZ)) * iz;
                cell(row, column, Math.max(inRow, low), Math.min(outRow, high));
            }
        }
    }

    private void cell(int row, int column, double in, double out) {
        if (!(in <= Math.min(out, limit))) {
            return;
        }
        int at = row * field.columns + column;
        float a = field.heights[at];
        float b = field.heights[at + 1];
        float c = field.heights[at + field.columns];
        float d = field.heights[at + field.columns + 1];
        double from = oy + in * dy;
        double to = oy + out * dy;
        if (Math.max(from, to) < Math.min(Math.min(a, b), Math.min(c, d)) - slackY
            || Math.min(from, to) > Math.max(Math.max(a, b), Math.max(c, d)) + slackY) {
            return;
        }
        for (int half = 0; half < 2; half++) {
            triangles++;
            field.triangle(row, column, half, corners);
            double t = RayTriangle.meet(corners, 0, ox, oy, oz, dx, dy, dz);
            long number = 2L * at + half;
            if (t <= limit && (t < best || t == best && number < triangle)) {
                best = t;
                limit = t;
                triangle = number;
            }
        }
    }

    /** Writes the upward normal of the triangle that the last successful {@link #meet} met, of any length. */
    public void normal(HeightField heights, double[] out) {
        int post = (int) (triangle / 2);
        heights.triangle(post / heights.columns, post % heights.columns, (int) (triangle % 2), corners);
        RayTriangle.normal(corners, 0, out);
    }
}
