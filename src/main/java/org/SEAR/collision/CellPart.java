// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Part of a mesh in an axis-aligned cell: its polygons, cut at the cell's sides, and its convex hull. Immutable. */
final class CellPart {
    /** Distance within which corners are on a plane, as a share of a voxel. */
    private static final double NEAR = 1e-4;
    /** Distance outside the hull that counts as inside, as a share of a voxel. */
    private static final double INSIDE = 1e-3;
    /** Cuts tried along an axis besides those at faces. */
    private static final int CUTS = 16;
    /** Weight of the difference of both parts' volumes against their sum. */
    private static final double BALANCE = 0.05;
    /** Weight of the extents that are left: a ring has to be cut several times before its hulls become smaller. */
    private static final double SHAPE = 0.1;
    /** Largest number of corners of a hull. */
    static final int CORNERS = 100;
    private static final double[][] DIRECTIONS = directions();

    final List<double[]> polygons;
    final ConvexHull hull;
    /** Number of voxels in the hull that are outside the solid. */
    final int empty;
    /** Number of voxels in the hull. */
    final int filled;
    private final VoxelGrid grid;
    /** Sides of the cell: least x, y, z and greatest x, y, z, metres. */
    private final double[] cell;
    private final int[] first = new int[3];
    private final int[] last = new int[3];

    /** @param points of the hull */
    private CellPart(VoxelGrid grid, List<double[]> polygons, double[] cell, double[] points) {
        this.grid = grid;
        this.polygons = polygons;
        this.cell = cell;
        hull = ConvexHull.of(points, CORNERS);
        setRange();
        int[] voxels = countVoxels(grid, hull, first, last);
        filled = voxels[0];
        empty = voxels[1];
    }

    /**
     * Returns the part in a cell; null if there is none.
     * @param polygons inside the cell
     * @param cell least x, y, z and greatest x, y, z, metres
     */
    static CellPart of(VoxelGrid grid, List<double[]> polygons, double[] cell) {
        double[] points = points(grid, polygons, cell);
        return points.length == 0 ? null : new CellPart(grid, polygons, cell, points);
    }

    private static double[][] directions() {
        List<double[]> all = new ArrayList<>();
        for (int code = 0; code < 125; code++) {
            int x = code % 5 - 2;
            int y = code / 5 % 5 - 2;
            int z = code / 25 - 2;
            int most = Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.abs(z));
            if (most == 1 || most == 2 && Math.abs(x) + Math.abs(y) + Math.abs(z) == 3) {
                all.add(new double[] {x, y, z});
            }
        }
        return all.toArray(new double[0][]);
    }

    private void setRange() {
        for (int axis = 0; axis < 3; axis++) {
            first[axis] = grid.index(axis, cell[axis] + NEAR * grid.size);
            last[axis] = grid.index(axis, cell[axis + 3] - NEAR * grid.size);
        }
    }

    /** Returns the polygons' corners, and the ends of rows of voxels inside the solid, which polygons don't reach. */
    private static double[] points(VoxelGrid grid, List<double[]> polygons, double[] cell) {
        double[] points = new double[96];
        int size = 0;
        for (double[] polygon : polygons) {
            points = size + polygon.length > points.length ? Arrays.copyOf(points, 2 * size + polygon.length) : points;
            System.arraycopy(polygon, 0, points, size, polygon.length);
            size += polygon.length;
        }
        double near = NEAR * grid.size;
        for (int k = grid.index(2, cell[2] + near); k <= grid.index(2, cell[5] - near); k++) {
            for (int j = grid.index(1, cell[1] + near); j <= grid.index(1, cell[4] - near); j++) {
                int from = grid.index(0, cell[0] + near);
                int to = grid.index(0, cell[3] - near);
                while (from <= to && !grid.isInside(from, j, k)) {
                    from++;
                }
                while (from < to && !grid.isInside(to, j, k)) {
                    to--;
                }
                if (from <= to) {
                    points = size + 24 > points.length ? Arrays.copyOf(points, 2 * size + 24) : points;
                    size = addRow(grid, cell, new int[] {from, j, k, to, j, k}, points, size);
                }
            }
        }
        return Arrays.copyOf(points, size);
    }

    /** Adds the corners of a row of voxels, clipped to the cell. */
    private static int addRow(VoxelGrid grid, double[] cell, int[] row, double[] points, int size) {
        for (int corner = 0; corner < 8; corner++) {
            for (int axis = 0; axis < 3; axis++) {
                boolean upper = (corner >> axis & 1) == 1;
                double at = grid.low[axis] + (upper ? row[axis + 3] + 1 : row[axis]) * grid.size;
                points[size + 3 * corner + axis] = upper ? Math.min(at, cell[axis + 3]) : Math.max(at, cell[axis]);
            }
        }
        return size + 24;
    }

    /** Returns the numbers of voxels with their centre in the hull, and of those that are outside the solid. */
    static int[] countVoxels(VoxelGrid grid, ConvexHull hull, int[] first, int[] last) {
        int[] found = new int[2];
        double[] range = new double[2];
        for (int k = first[2]; k <= last[2]; k++) {
            for (int j = first[1]; j <= last[1]; j++) {
                range[0] = grid.centre(0, first[0]);
                range[1] = grid.centre(0, last[0]);
                hull.clip(grid.centre(1, j), grid.centre(2, k), INSIDE * grid.size, range);
                int from = (int) Math.ceil((Math.min(range[0], grid.centre(0, last[0] + 1)) - grid.centre(0, 0))
                    / grid.size);
                for (int i = from; i <= last[0] && grid.centre(0, i) <= range[1]; i++) {
                    found[0]++;
                    found[1] += grid.isSolid(i, j, k) ? 0 : 1;
                }
            }
        }
        return found;
    }

    /**
     * Cuts the part in two where both hulls together are smallest.
     * @param faces coordinates of large faces along each axis, in the order of the voxels; NaN where there are none
     * @return two parts; null if the cell is too small
     */
    CellPart[] cut(double[][] faces) {
        CellPart[] best = null;
        double least = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            int index = estimate(axis, faces[axis]);
            double[] planes = index < 0 ? new double[0] : planes(faces[axis], axis, index);
            for (double plane : planes) {
                CellPart[] both = cut(axis, plane);
                double cost = both == null ? Double.POSITIVE_INFINITY : cost(both[0].hull, both[1].hull, axis, plane);
                if (cost < least) {
                    least = cost;
                    best = both;
                }
            }
        }
        return best;
    }

    private double cost(ConvexHull a, ConvexHull b, int axis, double plane) {
        double all = 0;
        double left = 0;
        for (int k = 0; k < 3; k++) {
            double length = cell[k + 3] - cell[k];
            all += length;
            left += k == axis ? Math.max(plane - cell[k], cell[k + 3] - plane) : length;
        }
        return a.volume() + b.volume() + BALANCE * Math.abs(a.volume() - b.volume())
            + SHAPE * hull.volume() * left / all;
    }

    /** Returns the side of a voxel, and the faces beside it that are inside the cell. */
    private double[] planes(double[] faces, int axis, int index) {
        double[] planes = {grid.low[axis] + index * grid.size, faces[index - 1], faces[index]};
        double near = 10 * NEAR * grid.size;
        return Arrays.stream(planes).filter(plane -> plane > cell[axis] + near && plane < cell[axis + 3] - near)
            .toArray();
    }

    private CellPart[] cut(int axis, double plane) {
        double near = NEAR * grid.size;
        List<double[]> lower = new ArrayList<>();
        List<double[]> upper = new ArrayList<>();
        double[] range = new double[6];
        for (double[] polygon : polygons) {
            ClippedPolygon.bounds(polygon, range);
            if (range[axis] >= plane - near && range[axis + 3] <= plane + near) {
                (isUp(polygon, axis) ? lower : upper).add(polygon);
                continue;
            }
            add(lower, ClippedPolygon.clip(polygon, axis, plane, 1, near));
            add(upper, ClippedPolygon.clip(polygon, axis, plane, -1, near));
        }
        double[] below = cell.clone();
        double[] above = cell.clone();
        below[axis + 3] = plane;
        above[axis] = plane;
        CellPart a = of(grid, lower, below);
        CellPart b = of(grid, upper, above);
        return a == null || b == null ? null : new CellPart[] {a, b};
    }

    private static void add(List<double[]> into, double[] polygon) {
        if (polygon != null) {
            into.add(polygon);
        }
    }

    /** Whether the normal of a polygon points along an axis: then the solid is below. */
    private static boolean isUp(double[] p, int axis) {
        int u = (axis + 1) % 3;
        int v = (axis + 2) % 3;
        double area = 0;
        for (int i = 0; i < p.length; i += 3) {
            int next = (i + 3) % p.length;
            area += p[i + u] * p[next + v] - p[next + u] * p[i + v];
        }
        return area > 0;
    }

    /** Returns the index of the voxels before which a cut along an axis is estimated best; -1 if there is none. */
    private int estimate(int axis, double[] faces) {
        int slabs = last[axis] - first[axis] + 1;
        double[][] above = new double[slabs + 1][];
        double[][] supports = new double[slabs][];
        for (int slab = slabs - 1; slab >= 0; slab--) {
            supports[slab] = support(axis, first[axis] + slab);
            above[slab] = merge(supports[slab], above[slab + 1]);
        }
        double[] below = null;
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        int step = (slabs + CUTS - 1) / CUTS;
        for (int slab = 1; slab < slabs; slab++) {
            below = merge(below, supports[slab - 1]);
            int index = first[axis] + slab;
            boolean tried = slab % step == 0 || !Double.isNaN(faces[index]) || !Double.isNaN(faces[index - 1]);
            if (tried && below != null && above[slab] != null) {
                double cost = cost(ConvexHull.of(below), ConvexHull.of(above[slab]), axis, grid.low[axis]
                    + index * grid.size);
                best = cost < least ? index : best;
                least = Math.min(least, cost);
            }
        }
        return best;
    }

    /** Returns the support points of a slab of solid voxels, one per direction; null if there are none. */
    private double[] support(int axis, int slab) {
        int u = (axis + 1) % 3;
        int v = (axis + 2) % 3;
        int[] voxel = new int[3];
        voxel[axis] = slab;
        double[] found = null;
        for (voxel[u] = first[u]; voxel[u] <= last[u]; voxel[u]++) {
            int from = first[v];
            int to = last[v];
            while (from <= to && !isSolid(voxel, v, from)) {
                from++;
            }
            while (from < to && !isSolid(voxel, v, to)) {
                to--;
            }
            if (from <= to) {
                isSolid(voxel, v, from);
                found = widen(widen(found, voxel, axis, -0.5), voxel, axis, 0.5);
                isSolid(voxel, v, to);
                found = widen(widen(found, voxel, axis, -0.5), voxel, axis, 0.5);
            }
        }
        return found;
    }

    private boolean isSolid(int[] voxel, int axis, int index) {
        voxel[axis] = index;
        return grid.isSolid(voxel[0], voxel[1], voxel[2]);
    }

    /** Extends support points to a voxel's centre, or along an axis to its side at {@code half} of its size. */
    private double[] widen(double[] supports, int[] voxel, int along, double half) {
        double[] point = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double at = grid.centre(axis, voxel[axis]) + (axis == along ? half * grid.size : 0);
            point[axis] = Math.max(cell[axis], Math.min(cell[axis + 3], at));
        }
        double[] widened = supports == null ? new double[3 * DIRECTIONS.length] : supports;
        for (int i = 0; i < DIRECTIONS.length; i++) {
            if (supports == null || isFurther(point, 0, widened, 3 * i, DIRECTIONS[i])) {
                System.arraycopy(point, 0, widened, 3 * i, 3);
            }
        }
        return widened;
    }

    private static double[] merge(double[] a, double[] b) {
        if (a == null || b == null) {
            return a == null ? b : a;
        }
        double[] merged = a.clone();
        for (int i = 0; i < DIRECTIONS.length; i++) {
            if (isFurther(b, 3 * i, a, 3 * i, DIRECTIONS[i])) {
                System.arraycopy(b, 3 * i, merged, 3 * i, 3);
            }
        }
        return merged;
    }

    private static boolean isFurther(double[] p, int i, double[] q, int k, double[] d) {
        return (p[i] - q[k]) * d[0] + (p[i + 1] - q[k + 1]) * d[1] + (p[i + 2] - q[k + 2]) * d[2] > 0;
    }
}
