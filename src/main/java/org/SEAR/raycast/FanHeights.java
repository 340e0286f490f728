package org.SEAR.raycast;

import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightPyramid;

/**
 * Cuts a {@link HeightField} with a fan's plane: walks down the pyramid of least and greatest heights (maximum mipmaps: Tevs, Ihrke and Seidel,
 * "Maximum mipmaps for fast, accurate, and scalable dynamic height field rendering", 2008) through the blocks that the plane meets, nearer ones
 * first. The part of the plane within a block lies in a circle; each block knows the first and the last of the beams that can still see into it. One
 * thread.
 */
final class FanHeights {
    /** Relative error of the plane's functions, many times over. */
    private static final double ROUNDING = 1e-13;
    /** Four blocks of each level at most. */
    private static final int DEPTH = 4 * Integer.SIZE;
    /** The level whose blocks are cut cell by cell. */
    private static final int LEAF = 1;
    /** With more than so many beams it pays to leave out those that pass beside a block. They are less than a quarter of a turn apart. */
    private static final int FEW = 4;
    /** An angle is at most this times its sine, where that is at most a half. */
    private static final double ARC_SINE = Math.PI / 3 * (1 + 1e-12);
    /** Metres from a block within which the origin counts as close to it: far more than what counts as touching a triangle. */
    private static final double CLOSE = 1e-3;

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
    /** Of the block looked at: the beams that may see into it, and whether they lie around it rather than it ahead of them. */
    private int first;
    private int last;
    private boolean around;
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
        push(pyramid.top, 0, 0, 0, heights.lowX + halfX[pyramid.top], heights.lowZ + halfZ[pyramid.top]);
        while (size > 0) {
            size--;
            if (see()) {
                nodes++;
                if (levels[size] > LEAF) {
                    open(pyramid, levels[size], rows[size], columns[size]);
                } else if (around) {
                    triangles += cells.meetAll(heights, CellCut.CELLS * rows[size], CellCut.CELLS * columns[size]);
                } else {
                    triangles += cells.meet(heights, CellCut.CELLS * rows[size], CellCut.CELLS * columns[size], first, last);
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

    /** Adds those of the four parts of a block that the plane meets within the range, the nearest last. */
    private void open(HeightPyramid pyramid, int level, int row, int column) {
        double x = field.lowX + (2 * row + 1) * halfX[level];
        double z = field.lowZ + (2 * column + 1) * halfZ[level];
        int near = (originX >= x ? 2 : 0) + (originZ >= z ? 1 : 0);
        int at = pyramid.children(level, row, column);
        double north = halfX[level - 1];
        double east = halfZ[level - 1];
        for (int k = 3; k >= 0; k--) {
            int part = near ^ k;
            push(level - 1, 2 * row + (part >> 1), 2 * column + (part & 1), at + 2 * part, part > 1 ? x + north : x - north,
                (part & 1) == 1 ? z + east : z - east);
        }
    }

    /** Keeps a block for later, if the plane meets it within the range. */
    private void push(int level, int row, int column, int at, double x, double z) {
        double y = ((double) data[at] + data[at + 1]) / 2;
        double halfY = data[at + 1] - y;
        if (!(Math.abs(plane.height(x, y, z)) <= reach[level] + steepness * halfY)) {
            return;
        }
        double left = plane.x(x, y, z);
        double ahead = plane.z(x, y, z);
        double far = radius[level] + tilt * halfY;
        if (left * left + ahead * ahead > (range + far) * (range + far)) {
            return;
        }
        levels[size] = level;
        rows[size] = row;
        columns[size] = column;
        xs[size] = left;
        zs[size] = ahead;
        radii[size] = far;
        firsts[size] = first;
        lasts[size++] = last;
    }

    /** Whether some beam sees into the block on top; finds the first and the last that do. */
    private boolean see() {
        double x = xs[size];
        double z = zs[size];
        double far = radii[size];
        double squared = x * x + z * z;
        first = firsts[size];
        last = lasts[size];
        around = squared <= 4 * far * far || squared < (far + CLOSE) * (far + CLOSE);
        if (around) {
            return true;
        }
        double distance = Math.sqrt(squared);
        double nearest = distance - far;
        double inverse = 1 / (distance * nearest);
        if (last - first >= FEW) {
            narrow(depth.beams.angle(x, z), ARC_SINE * far * nearest * inverse);
        }
        double enough = (1 + 1e-12) * distance * inverse;
        while (first <= last && !depth.isOpen(first, x, z, far, enough)) {
            first++;
        }
        while (last > first && !depth.isOpen(last, x, z, far, enough)) {
            last--;
        }
        return first <= last;
    }

    /** Leaves out beams that pass beside a circle. */
    private void narrow(double middle, double half) {
        FanDirections beams = depth.beams;
        if (FanDirections.inOneGo(middle - half, middle + half)) {
            first = Math.max(first, beams.from(middle - half));
            last = Math.min(last, beams.to(middle + half));
            return;
        }
        double right = middle < Math.PI ? middle - half + 2 * Math.PI : middle - half;
        if (beams.from(right) >= beams.count) {
            last = Math.min(last, beams.to(right + 2 * half - 2 * Math.PI));
        } else {
            around = last - first >= FEW;
        }
    }
}
