// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightPyramid;

/**
 * Intersects the rays of one picture tile with a {@link HeightField}. Walks the field's min/max pyramid once for the
 * frustum that contains all rays, nearer blocks first. Each ray is tested only against blocks that are small compared
 * with the tile. Skips blocks outside the frustum or behind the hits of all rays. The result of a ray equals that of
 * {@link RayHeights}. One thread; allocates nothing per tile.
 */
public final class HeightsTile {
    /** Maximum number of rays of a tile. */
    public static final int MOST = 64;
    /**
     * Number of planes that bound a tile. Four numbers per plane: inward normal and offset. The last normal points
     * ahead.
     */
    public static final int PLANES = 5;

    private static final int PLANE = 4;
    private static final int AHEAD = (PLANES - 1) * PLANE;
    /** Relative tolerance of the plane test, above its rounding error. */
    private static final double SLACK = 1e-9;
    /** Apparent size, in tile widths, below which each ray is tested against a block. */
    private static final double SMALL = 0.5;
    private static final int DEPTH = 4 * Integer.SIZE;
    private static final int BEAM = 8;
    private static final double LARGEST = 1e30;

    private final RayHeights ray;
    private final double[] beams = new double[BEAM * MOST];
    private final double[] limits = new double[MOST];
    private final double[] hit = new double[MOST];
    private final double[] planes = new double[PLANES * PLANE];
    private final double[] slacks = new double[PLANES];
    private final int[] levels = new int[DEPTH];
    private final int[] rows = new int[DEPTH];
    private final int[] columns = new int[DEPTH];
    private final float[] lows = new float[DEPTH];
    private final float[] highs = new float[DEPTH];
    private final double[] nears = new double[DEPTH];
    private final float[] eastern = new float[9];
    private final float[] western = new float[9];
    private int depth;
    private int count;
    private HeightField field;
    private HeightPyramid pyramid;
    private double wide;
    private double start;
    private double worst;
    private double farX;
    private double farY;
    private double farZ;
    private double slackX;
    private double slackY;
    private double slackZ;

    /** @param ray casts a single ray within a block */
    public HeightsTile(RayHeights ray) {
        this.ray = ray;
    }

    /**
     * Begins a tile without rays. All coordinates are in the field's frame. Distances ahead are measured along the last
     * plane's normal.
     * @param sides {@link #PLANES} planes
     * @param width width of the tile at one metre ahead, metres
     * @param from distance ahead at which the rays begin, metres
     */
    public void begin(HeightField heights, double[] sides, double width, double from) {
        field = heights;
        pyramid = heights.getPyramid();
        System.arraycopy(sides, 0, planes, 0, planes.length);
        wide = width;
        start = from;
        count = 0;
        farX = 0;
        farY = 0;
        farZ = 0;
    }

    /**
     * Adds a ray.
     * @param ox origin, metres, likewise oy and oz
     * @param dx direction, likewise dy and dz; its component ahead is one metre
     * @param limit maximum distance, in lengths of the direction
     */
    public void add(double ox, double oy, double oz, double dx, double dy, double dz, double limit) {
        int at = BEAM * count;
        beams[at] = ox;
        beams[at + 1] = oy;
        beams[at + 2] = oz;
        beams[at + 3] = dx;
        beams[at + 4] = dy;
        beams[at + 5] = dz;
        beams[at + 6] = inverse(dx);
        beams[at + 7] = inverse(dz);
        farX = Math.max(farX, Math.abs(ox));
        farY = Math.max(farY, Math.abs(oy));
        farZ = Math.max(farZ, Math.abs(oz));
        limits[count] = limit;
        hit[count++] = Double.POSITIVE_INFINITY;
    }

    private static double inverse(double d) {
        return Math.abs(d) < 1 / LARGEST ? Math.copySign(LARGEST, d) : 1 / d;
    }

    /**
     * Returns the distance from the ray's origin to the ground, in lengths of its direction; infinite without a hit.
     */
    public double distance(int beam) {
        return hit[beam];
    }

    /** Casts all added rays. */
    public void cast() {
        ray.look(field);
        slackX = ray.slackX(farX);
        slackZ = ray.slackZ(farZ);
        slackY = ray.slackY(farX + farY + farZ);
        double far = slackY / RayHeights.ROUNDING;
        for (int plane = 0; plane < PLANES; plane++) {
            slacks[plane] = SLACK * (1 + far + Math.abs(planes[PLANE * plane + 3]));
        }
        worst = 0;
        for (int i = 0; i < count; i++) {
            worst = Math.max(worst, start + limits[i]);
        }
        depth = 0;
        push(pyramid.top, 0, 0, pyramid.lowest(), pyramid.highest());
        while (depth > 0) {
            depth--;
            if (nears[depth] > worst) {
                continue;
            }
            int level = levels[depth];
            double size = (1 << level + 1) * Math.max(field.spacingX, field.spacingZ);
            if (level < 0) {
                cell(rows[depth], columns[depth], lows[depth], highs[depth]);
            } else if (size < SMALL * wide * nears[depth]) {
                ask(level, rows[depth], columns[depth], lows[depth], highs[depth]);
            } else {
                open(level, rows[depth], columns[depth]);
            }
        }
    }

    /** Pushes the four children of a block, the furthest first. */
    private void open(int level, int row, int column) {
        int bottom = depth;
        for (int part = 0; part < PLANE; part++) {
            int r = 2 * row + (part >> 1);
            int c = 2 * column + (part & 1);
            if (level > 0) {
                int at = pyramid.children(level, row, column) + 2 * part;
                push(level - 1, r, c, pyramid.data[at], pyramid.data[at + 1]);
            } else if (r < field.rows - 1 && c < field.columns - 1) {
                int at = r * field.columns + c;
                float south = field.heights[at];
                float southEast = field.heights[at + 1];
                float north = field.heights[at + field.columns];
                float northEast = field.heights[at + field.columns + 1];
                push(-1, r, c, Math.min(Math.min(south, southEast), Math.min(north, northEast)),
                    Math.max(Math.max(south, southEast), Math.max(north, northEast)));
            }
            for (int i = depth - 1; i > bottom && nears[i] > nears[i - 1]; i--) {
                swap(i);
            }
        }
    }

    private void swap(int i) {
        int level = levels[i];
        int row = rows[i];
        int column = columns[i];
        float low = lows[i];
        float high = highs[i];
        double near = nears[i];
        levels[i] = levels[i - 1];
        rows[i] = rows[i - 1];
        columns[i] = columns[i - 1];
        lows[i] = lows[i - 1];
        highs[i] = highs[i - 1];
        nears[i] = nears[i - 1];
        levels[i - 1] = level;
        rows[i - 1] = row;
        columns[i - 1] = column;
        lows[i - 1] = low;
        highs[i - 1] = high;
        nears[i - 1] = near;
    }

    /**
     * Pushes a block onto the stack if it intersects the tile. A cell is a block of level -1. Blocks outside the field
     * have low &gt; high.
     */
    private void push(int level, int row, int column, float low, float high) {
        ray.nodes++;
        if (low > high) {
            return;
        }
        double near = reach(level, row, column, low, high);
        if (near <= worst) {
            levels[depth] = level;
            rows[depth] = row;
            columns[depth] = column;
            lows[depth] = low;
            highs[depth] = high;
            nears[depth++] = near;
        }
    }

    /** Returns a lower bound of the distance ahead of a block, metres; infinite outside the frustum. */
    private double reach(int level, int row, int column, float low, float high) {
        int size = 1 << level + 1;
        double hx = size * field.spacingX / 2 + slackX;
        double hy = ((double) high - low) / 2 + slackY;
        double hz = size * field.spacingZ / 2 + slackZ;
        double x = field.lowX + (row + 0.5) * size * field.spacingX;
        double y = low + ((double) high - low) / 2;
        double z = field.lowZ + (column + 0.5) * size * field.spacingZ;
        double[] p = planes;
        for (int k = 0; k < AHEAD; k += PLANE) {
            double most = p[k] * x + p[k + 1] * y + p[k + 2] * z + p[k + 3] + Math.abs(p[k]) * hx
                + Math.abs(p[k + 1]) * hy + Math.abs(p[k + 2]) * hz;
            if (most < -slacks[k / PLANE]) {
                return Double.POSITIVE_INFINITY;
            }
        }
        double middle = p[AHEAD] * x + p[AHEAD + 1] * y + p[AHEAD + 2] * z + p[AHEAD + 3];
        double half = Math.abs(p[AHEAD]) * hx + Math.abs(p[AHEAD + 1]) * hy + Math.abs(p[AHEAD + 2]) * hz
            + slacks[PLANES - 1];
        return middle + half < start ? Double.POSITIVE_INFINITY : middle - half;
    }

    private void cell(int row, int column, float low, float high) {
        field.triangle(row, column, 0, eastern);
        field.triangle(row, column, 1, western);
        ask(-1, row, column, low, high);
    }

    /** Tests a block against each ray that passes through its bounds. */
    private void ask(int level, int row, int column, float low, float high) {
        int size = 1 << level + 1;
        double south = field.lowX + row * size * field.spacingX - slackX;
        double north = field.lowX + (row + 1) * size * field.spacingX + slackX;
        double west = field.lowZ + column * size * field.spacingZ - slackZ;
        double east = field.lowZ + (column + 1) * size * field.spacingZ + slackZ;
        double lowest = low - slackY;
        double highest = high + slackY;
        double[] b = beams;
        double most = 0;
        for (int i = 0; i < count; i++) {
            int at = BEAM * i;
            double ix = b[at + 6];
            double iz = b[at + 7];
            double southT = (south - b[at]) * ix;
            double northT = (north - b[at]) * ix;
            double westT = (west - b[at + 2]) * iz;
            double eastT = (east - b[at + 2]) * iz;
            double in = Math.max(0, Math.max(Math.min(southT, northT), Math.min(westT, eastT)));
            double out = Math.min(limits[i], Math.min(Math.max(southT, northT), Math.max(westT, eastT)));
            double inY = b[at + 1] + in * b[at + 4];
            double outY = b[at + 1] + out * b[at + 4];
            if (in <= out && Math.max(inY, outY) >= lowest && Math.min(inY, outY) <= highest) {
                if (level < 0) {
                    triangle(eastern, i);
                    triangle(western, i);
                } else {
                    take(i, ray.within(b, at, level, row, column, in, out, limits[i]));
                }
            }
            most = Math.max(most, limits[i]);
        }
        worst = start + most;
    }

    private void triangle(float[] corners, int i) {
        ray.triangles++;
        int at = BEAM * i;
        take(i, RayTriangle.intersect(corners, 0, beams[at], beams[at + 1], beams[at + 2], beams[at + 3], beams[at + 4],
            beams[at + 5]));
    }

    private void take(int i, double t) {
        if (t <= limits[i] && t < hit[i]) {
            hit[i] = t;
            limits[i] = t;
        }
    }
}
