package org.SEAR.raycast;

import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightPyramid;

/**
 * Cuts a {@link HeightField} with a fan's plane: walks the blocks of its pyramid that the plane meets, nearer ones first. The part of the plane
 * within a block lies in a circle; each block knows the first and the last of the beams that can still see into it. One thread.
 */
final class FanHeights {
    /** Relative error of the plane's functions, many times over. */
    private static final double ROUNDING = 1e-13;
    /** Four blocks of each level at most. */
    private static final int DEPTH = 4 * Integer.SIZE;
    /** From so many beams on their directions are found by angle, not one by one. */
    private static final int MANY = 24;
    /** An angle is at most this times its sine, where that is at most a half. */
    private static final double ARC_SINE = Math.PI / 3 * (1 + 1e-12);

    /** Blocks and triangles that the last {@link #cast} looked at. */
    int nodes;
    int triangles;

    private final DepthBuffer depth;
    private final PlaneCut plane;
    private final CellCut cells;
    private final int[] levels = new int[DEPTH];
    private final int[] rows = new int[DEPTH];
    private final int[] columns = new int[DEPTH];
    /** Of each block: the middle of its part of the plane in the fan's frame, and how far it reaches around it. */
    private final double[] xs = new double[DEPTH];
    private final double[] zs = new double[DEPTH];
    private final double[] radii = new double[DEPTH];
    /** Of each block: the beams that may see into it. */
    private final int[] firsts = new int[DEPTH];
    private final int[] lasts = new int[DEPTH];
    private int size;
    private int first;
    private int last;
    private HeightField field;
    private float[] data;
    private double range;
    /** By level: half of a block's sides and of its diagonal, and how far that reaches from the plane. */
    private final double[] halfX = new double[Integer.SIZE];
    private final double[] halfZ = new double[Integer.SIZE];
    private final double[] radius = new double[Integer.SIZE];
    private final double[] reach = new double[Integer.SIZE];
    /** How much the heights within a block reach from the plane, and how much they spread its part of it: 0 for a level fan. */
    private double steepness;
    private double tilt;
    /** Where the fan starts: by it the nearest parts of blocks are found. */
    private double originX;
    private double originZ;

    FanHeights(DepthBuffer depth, TriangleCut cut) {
        this.depth = depth;
        plane = cut.plane;
        cells = new CellCut(depth, cut);
    }

    /**
     * Meets the field, when the cut has been started.
     *
     * @param originOfX of the fan in the field's frame, likewise originOfZ
     */
    void cast(HeightField heights, double originOfX, double originOfZ, double maxRange) {
        originX = originOfX;
        originZ = originOfZ;
        range = maxRange;
        HeightPyramid pyramid = heights.getPyramid();
        measure(heights, pyramid);
        size = 0;
        nodes = 0;
        triangles = 0;
        first = 0;
        last = depth.beams.count - 1;
        push(pyramid.top, 0, 0, 0);
        while (size > 0) {
            size--;
            if (see()) {
                nodes++;
                if (levels[size] == 0) {
                    triangles += cells.meet(heights, 2 * rows[size], 2 * columns[size], first, last);
                } else {
                    open(pyramid, levels[size], rows[size], columns[size]);
                }
            }
        }
    }

    private void measure(HeightField heights, HeightPyramid pyramid) {
        field = heights;
        data = pyramid.data;
        double farX = Math.max(Math.abs(heights.x(0)), Math.abs(heights.x(heights.rows - 1)));
        double farZ = Math.max(Math.abs(heights.z(0)), Math.abs(heights.z(heights.columns - 1)));
        double slack = ROUNDING * (farX + farZ + Math.max(Math.abs(data[0]), Math.abs(data[1])) + Math.abs(plane.hd) + Math.abs(plane.xd)
            + Math.abs(plane.zd));
        for (int level = 0; level <= pyramid.top; level++) {
            halfX[level] = (1 << level) * heights.spacingX;
            halfZ[level] = (1 << level) * heights.spacingZ;
            double x = halfX[level] + Math.ulp((float) farX);
            double z = halfZ[level] + Math.ulp((float) farZ);
            reach[level] = Math.abs(plane.ha) * x + Math.abs(plane.hc) * z + slack;
            radius[level] = Math.sqrt(x * x + z * z) + slack;
        }
        steepness = Math.abs(plane.hb);
        tilt = Math.sqrt(plane.xb * plane.xb + plane.zb * plane.zb);
    }

    /** Adds the four parts of a block, the nearest last. */
    private void open(HeightPyramid pyramid, int level, int row, int column) {
        int at = pyramid.children(level, row, column);
        int north = originX >= field.lowX + (2 * row + 1) * halfX[level] ? 1 : 0;
        int east = originZ >= field.lowZ + (2 * column + 1) * halfZ[level] ? 1 : 0;
        int r = 2 * row;
        int c = 2 * column;
        push(level - 1, r + 1 - north, c + 1 - east, at + 4 * (1 - north) + 2 * (1 - east));
        push(level - 1, r + 1 - north, c + east, at + 4 * (1 - north) + 2 * east);
        push(level - 1, r + north, c + 1 - east, at + 4 * north + 2 * (1 - east));
        push(level - 1, r + north, c + east, at + 4 * north + 2 * east);
    }

    /** Keeps a block for later, if the plane meets it within the range. */
    private void push(int level, int row, int column, int at) {
        double x = field.lowX + (2 * row + 1) * halfX[level];
        double y = ((double) data[at] + data[at + 1]) / 2;
        double z = field.lowZ + (2 * column + 1) * halfZ[level];
        double halfY = data[at + 1] - y;
        if (!(Math.abs(plane.height(x, y, z)) <= reach[level] + steepness * halfY)) {
            return;
        }
        double left = plane.x(x, y, z);
        double ahead = plane.z(x, y, z);
        double around = radius[level] + tilt * halfY;
        if (left * left + ahead * ahead > (range + around) * (range + around)) {
            return;
        }
        levels[size] = level;
        rows[size] = row;
        columns[size] = column;
        xs[size] = left;
        zs[size] = ahead;
        radii[size] = around;
        firsts[size] = first;
        lasts[size++] = last;
    }

    /** Whether some beam sees into the block on top; finds the first and the last that do. */
    private boolean see() {
        double x = xs[size];
        double z = zs[size];
        double around = radii[size];
        first = firsts[size];
        last = lasts[size];
        if (last - first >= MANY) {
            double squared = x * x + z * z;
            if (squared <= 4 * around * around) {
                return true;
            }
            narrow(x, z, around / Math.sqrt(squared));
        }
        while (first <= last && !depth.isOpen(first, x, z, around)) {
            first++;
        }
        while (last > first && !depth.isOpen(last, x, z, around)) {
            last--;
        }
        return first <= last;
    }

    /** Leaves out beams that pass beside a circle. */
    private void narrow(double x, double z, double sine) {
        double half = ARC_SINE * sine;
        double middle = depth.beams.angle(x, z);
        if (FanDirections.inOneGo(middle - half, middle + half)) {
            first = Math.max(first, depth.beams.from(middle - half));
            last = Math.min(last, depth.beams.to(middle + half));
        }
    }
}
