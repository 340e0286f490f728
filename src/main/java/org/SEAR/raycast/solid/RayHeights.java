// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightPyramid;

/**
 * Intersection of a ray with a {@link HeightField}. Leads the ray through the field's min/max pyramid, nearer blocks
 * first (maximum mipmaps: Tevs, Ihrke and Seidel 2008), to the cells whose triangles it may hit. Blocks are enlarged by
 * more than the rounding of the tests, so that no touched cell is missed. One thread.
 */
public final class RayHeights {
    /** Replaces 1 / 0. */
    private static final double LARGEST = 1e30;
    /**
     * Relative tolerance of a point on the ray, above its rounding error. Relative to the distances of field and
     * origin.
     */
    static final double ROUNDING = 1e-12;
    /** At most four blocks per level and four cells. */
    private static final int DEPTH = 4 * Integer.SIZE;

    /** Number of blocks visited since construction. */
    public long nodes;
    /** Number of triangles tested since construction. */
    public long triangles;

    private final int[] levels = new int[DEPTH];
    private final int[] rows = new int[DEPTH];
    private final int[] columns = new int[DEPTH];
    private final double[] ins = new double[DEPTH];
    private final double[] outs = new double[DEPTH];
    private int depth;
    private final float[] corners = new float[9];
    private HeightField field;
    private HeightPyramid pyramid;
    private float[] data;
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;
    private double ix;
    private double iz;
    /** 1 if the ray goes north or east. Otherwise the other half of a block comes first. */
    private int north;
    private int east;
    /** The field's rounding error in x and z, and its maximum absolute coordinates added up, metres. */
    private double ulpX;
    private double ulpZ;
    private double far;
    /** Cells per metre. */
    private double perX;
    private double perZ;
    /** Tolerance of a point on the ray, metres; ahead: with the sign of the direction. */
    private double slackX;
    private double slackY;
    private double slackZ;
    private double aheadX;
    private double aheadZ;
    private double best;
    private double limit;
    /**
     * Triangle of the last successful {@link #intersect}: twice the number of its south-western post, plus 1 west of
     * the diagonal.
     */
    private long triangle;

    /**
     * Returns the distance to the nearest triangle within maxRange, both in lengths of the direction. Of equally near
     * triangles the first wins.
     */
    public double intersect(HeightField heights, double px, double py, double pz, double vx, double vy, double vz,
        double maxRange) {
        look(heights);
        aim(px, py, pz, vx, vy, vz);
        best = Double.POSITIVE_INFINITY;
        limit = maxRange;
        depth = 0;
        start();
        return run();
    }

    /**
     * Intersects one block only, given that the ray passes between its minimum and maximum height.
     * @param ray origin and direction
     * @param from index of the origin in ray
     * @param in distance at which the ray enters the block, likewise out where it leaves
     */
    double within(double[] ray, int from, int level, int row, int column, double in, double out, double maxRange) {
        aim(ray[from], ray[from + 1], ray[from + 2], ray[from + 3], ray[from + 4], ray[from + 5]);
        best = Double.POSITIVE_INFINITY;
        limit = maxRange;
        depth = 0;
        open(level, row, column, in, out);
        return run();
    }

    void look(HeightField heights) {
        if (heights != field) {
            measure(heights);
        }
    }

    /** Tolerance for a ray whose origin is this far from the field's origin, metres. */
    double slackX(double distance) {
        return ulpX + ROUNDING * distance;
    }

    double slackY(double distance) {
        return ROUNDING * (far + distance);
    }

    double slackZ(double distance) {
        return ulpZ + ROUNDING * distance;
    }

    private void aim(double px, double py, double pz, double vx, double vy, double vz) {
        ox = px;
        oy = py;
        oz = pz;
        dx = vx;
        dy = vy;
        dz = vz;
        ix = inverse(vx);
        iz = inverse(vz);
        north = ix < 0 ? 0 : 1;
        east = iz < 0 ? 0 : 1;
        slackX = slackX(Math.abs(ox));
        slackZ = slackZ(Math.abs(oz));
        slackY = slackY(Math.abs(oy) + Math.abs(ox) + Math.abs(oz));
        aheadX = north == 1 ? slackX : -slackX;
        aheadZ = east == 1 ? slackZ : -slackZ;
    }

    private double run() {
        while (depth > 0) {
            depth--;
            nodes++;
            if (ins[depth] > limit) {
                continue;
            }
            if (levels[depth] < 0) {
                cell(rows[depth], columns[depth]);
            } else {
                open(levels[depth], rows[depth], columns[depth], ins[depth], Math.min(outs[depth], limit));
            }
        }
        return best;
    }

    private static double inverse(double d) {
        return Math.abs(d) < 1 / LARGEST ? Math.copySign(LARGEST, d) : 1 / d;
    }

    private void measure(HeightField heights) {
        field = heights;
        pyramid = heights.getPyramid();
        data = pyramid.data;
        double farX = Math.max(Math.abs(heights.x(0)), Math.abs(heights.x(heights.rows - 1)));
        double farZ = Math.max(Math.abs(heights.z(0)), Math.abs(heights.z(heights.columns - 1)));
        ulpX = Math.ulp((float) farX);
        ulpZ = Math.ulp((float) farZ);
        perX = 1 / heights.spacingX;
        perZ = 1 / heights.spacingZ;
        far = Math.max(Math.abs(data[0]), Math.abs(data[1])) + farX + farZ;
    }

    /** Begins with the smallest block that contains the ray's part over the field. */
    private void start() {
        double sizeX = (field.rows - 1) * field.spacingX;
        double sizeZ = (field.columns - 1) * field.spacingZ;
        double nearX = (field.lowX + (1 - north) * sizeX - ox - aheadX) * ix;
        double farX = (field.lowX + north * sizeX - ox + aheadX) * ix;
        double nearZ = (field.lowZ + (1 - east) * sizeZ - oz - aheadZ) * iz;
        double farZ = (field.lowZ + east * sizeZ - oz + aheadZ) * iz;
        double in = Math.max(0, Math.max(nearX, nearZ));
        double out = Math.min(limit, Math.min(farX, farZ));
        if (in <= out) {
            double fromX = ox + in * dx;
            double toX = ox + out * dx;
            double fromZ = oz + in * dz;
            double toZ = oz + out * dz;
            int south = row(Math.min(fromX, toX) - slackX);
            int west = column(Math.min(fromZ, toZ) - slackZ);
            int apart = south ^ row(Math.max(fromX, toX) + slackX) | west ^ column(Math.max(fromZ, toZ) + slackZ);
            int level = Integer.SIZE - 1 - Integer.numberOfLeadingZeros(apart | 1);
            int at = pyramid.block(level, south >> level + 1, west >> level + 1);
            push(level, south >> level + 1, west >> level + 1, data[at], data[at + 1], in, out);
        }
    }

    /** Returns the row of cells at x, clamped to the field. */
    private int row(double x) {
        return Math.max(0, Math.min((int) ((x - field.lowX) * perX), field.rows - 2));
    }

    private int column(double z) {
        return Math.max(0, Math.min((int) ((z - field.lowZ) * perZ), field.columns - 2));
    }

    /**
     * Pushes a block if the ray's part over it passes between its minimum and maximum height. A cell is a block of
     * level -1.
     */
    private void push(int level, int row, int column, float lowest, float highest, double in, double out) {
        boolean falls = dy < 0;
        double low = oy + (falls ? out : in) * dy;
        double high = oy + (falls ? in : out) * dy;
        if (high >= lowest - slackY && low <= highest + slackY) {
            levels[depth] = level;
            rows[depth] = row;
            columns[depth] = column;
            ins[depth] = in;
            outs[depth++] = out;
        }
    }

    /** Pushes the children of a block under the ray, furthest first. */
    private void open(int level, int row, int column, double in, double out) {
        int size = 1 << level;
        double x = field.lowX + (2 * row + 1) * size * field.spacingX - ox;
        double z = field.lowZ + (2 * column + 1) * size * field.spacingZ - oz;
        double leaveX = (x + aheadX) * ix;
        double enterX = (x - aheadX) * ix;
        double leaveZ = (z + aheadZ) * iz;
        double enterZ = (z - aheadZ) * iz;
        if (enterX <= out) {
            half(level, row, column, north, Math.max(in, enterX), out, enterZ, leaveZ);
        }
        if (leaveX >= in) {
            half(level, row, column, 1 - north, in, Math.min(out, leaveX), enterZ, leaveZ);
        }
    }

    /** Pushes the children of a block's southern or northern half. */
    private void half(int level, int row, int column, int northern, double in, double out, double enterZ,
        double leaveZ) {
        if (enterZ <= out) {
            part(level, row, column, northern, east, Math.max(in, enterZ), out);
        }
        if (leaveZ >= in) {
            part(level, row, column, northern, 1 - east, in, Math.min(out, leaveZ));
        }
    }

    private void part(int level, int row, int column, int northern, int eastern, double in, double out) {
        int r = 2 * row + northern;
        int c = 2 * column + eastern;
        float lowest;
        float highest;
        if (level > 0) {
            int at = pyramid.children(level, row, column) + 4 * northern + 2 * eastern;
            lowest = data[at];
            highest = data[at + 1];
        } else if (r < field.rows - 1 && c < field.columns - 1) {
            int at = r * field.columns + c;
            float a = field.heights[at];
            float b = field.heights[at + 1];
            float d = field.heights[at + field.columns];
            float e = field.heights[at + field.columns + 1];
            lowest = Math.min(Math.min(a, b), Math.min(d, e));
            highest = Math.max(Math.max(a, b), Math.max(d, e));
        } else {
            return;
        }
        push(level - 1, r, c, lowest, highest, in, out);
    }

    private void cell(int row, int column) {
        for (int half = 0; half < 2; half++) {
            triangles++;
            field.triangle(row, column, half, corners);
            double t = RayTriangle.intersect(corners, 0, ox, oy, oz, dx, dy, dz);
            long number = 2L * (row * field.columns + column) + half;
            if (t <= limit && (t < best || t == best && number < triangle)) {
                best = t;
                limit = t;
                triangle = number;
            }
        }
    }

    /** Writes the upward normal, of any length, of the triangle of the last successful {@link #intersect}. */
    public void normal(HeightField heights, double[] out) {
        int post = (int) (triangle / 2);
        heights.triangle(post / heights.columns, post % heights.columns, (int) (triangle % 2), corners);
        RayTriangle.normal(corners, 0, out);
    }
}
