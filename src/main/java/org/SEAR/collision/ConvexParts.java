// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleConsumer;

/**
 * Approximate convex decomposition. The part whose hull has most empty voxels is cut in two, across an axis of
 * {@link FaceAxes}, until hulls are nearly full. Neighbours whose common hull is nearly full become one. The scheme is
 * that of Mamou, "Volumetric hierarchical approximate convex decomposition", Game Engine Gems 3, 2016; hulls are those
 * of the cut triangles. The same mesh always gives the same parts. Any thread.
 */
public final class ConvexParts {
    /** Largest number of parts. */
    public static final int MAX_PARTS = 32;
    /** Largest number of triangles. */
    public static final int MAX_TRIANGLES = 250_000;
    /** Number of parts before parts become one again. */
    private static final int MAX_CUT = 48;
    /** Largest number of polygons of all parts together, which bounds time and memory. */
    private static final int MAX_POLYGONS = 1_000_000;
    /** Share of the whole hull's voxels that may be empty in a part, and their least number. */
    private static final double EMPTY = 1e-3;
    private static final int LEAST_EMPTY = 4;
    /** Thickness of a face, as a share of a voxel, and its least area, as a multiple of a voxel's side. */
    private static final double FLAT = 1e-3;
    private static final double FACE = 16;
    /** Share of volume that a union of two parts may add. */
    private static final double ADDED = 0.02;
    /** Share of the work until all parts are cut. */
    private static final double CUTTING = 0.5;
    /** Distance within which parts are neighbours, as a share of a voxel. */
    private static final double BESIDE = 0.1;

    private final VoxelGrid grid;
    private final double[][] faces = new double[3][];
    private final List<CellPart> parts = new ArrayList<>();
    /** Number of empty voxels that a part may have. */
    private final double allowed;
    private final DoubleConsumer progress;

    private ConvexParts(List<double[]> polygons, DoubleConsumer progress) {
        this.progress = progress;
        double[] cell = bounds(polygons);
        grid = new VoxelGrid(polygons, Arrays.copyOf(cell, 3), Arrays.copyOfRange(cell, 3, 6));
        for (int axis = 0; axis < 3; axis++) {
            faces[axis] = faces(polygons, axis);
        }
        CellPart whole = CellPart.of(grid, polygons, cell);
        allowed = Math.max(LEAST_EMPTY, EMPTY * whole.filled);
        parts.add(whole);
        cutAll();
    }

    /**
     * @param points x, y, z of each vertex, metres
     * @param indices three per triangle, at least one triangle
     * @param progress takes the done share of the work, 0 to 1, many times
     * @return at most {@link #MAX_PARTS} hulls that contain all triangles
     */
    public static List<ConvexHull> of(double[] points, int[] indices, DoubleConsumer progress) {
        FaceAxes axes = FaceAxes.of(points, indices);
        double[] turned = axes.along(points);
        List<double[]> triangles = new ArrayList<>();
        for (int i = 0; i < indices.length; i += 3) {
            double[] triangle = new double[9];
            for (int k = 0; k < 3; k++) {
                System.arraycopy(turned, 3 * indices[i + k], triangle, 3 * k, 3);
            }
            triangles.add(triangle);
        }
        List<ConvexHull> hulls = new ConvexParts(triangles, progress).union();
        hulls.replaceAll(hull -> ConvexHull.of(axes.back(hull.corners())));
        return hulls;
    }

    private static double[] bounds(List<double[]> polygons) {
        double[] all = polygons.get(0).clone();
        double[] bounds = new double[6];
        double[] range = new double[6];
        ClippedPolygon.bounds(all, bounds);
        for (double[] polygon : polygons) {
            ClippedPolygon.bounds(polygon, range);
            for (int axis = 0; axis < 3; axis++) {
                bounds[axis] = Math.min(bounds[axis], range[axis]);
                bounds[axis + 3] = Math.max(bounds[axis + 3], range[axis + 3]);
            }
        }
        return bounds;
    }

    /** Returns the coordinate of large faces across an axis in each slab of voxels; NaN if there are none. */
    private double[] faces(List<double[]> polygons, int axis) {
        double[] at = new double[grid.count[axis]];
        double[] most = new double[at.length];
        double[] sums = new double[at.length];
        double[] range = new double[6];
        for (double[] polygon : polygons) {
            ClippedPolygon.bounds(polygon, range);
            if (range[axis + 3] - range[axis] < FLAT * grid.size) {
                double area = (range[(axis + 1) % 3 + 3] - range[(axis + 1) % 3]) * (
                    range[(axis + 2) % 3 + 3] - range[(axis + 2) % 3]);
                int slab = grid.index(axis, range[axis]);
                sums[slab] += area;
                at[slab] = area > most[slab] ? range[axis] : at[slab];
                most[slab] = Math.max(most[slab], area);
            }
        }
        for (int slab = 0; slab < at.length; slab++) {
            at[slab] = sums[slab] > FACE * grid.size * grid.size ? at[slab] : Double.NaN;
        }
        return at;
    }

    private void cutAll() {
        List<CellPart> whole = new ArrayList<>();
        while (!parts.isEmpty() && parts.size() + whole.size() < MAX_CUT) {
            progress.accept(CUTTING * (parts.size() + whole.size()) / MAX_CUT);
            int worst = 0;
            int polygons = 0;
            for (int i = 0; i < parts.size(); i++) {
                worst = parts.get(i).empty > parts.get(worst).empty ? i : worst;
                polygons += parts.get(i).polygons.size();
            }
            if (parts.get(worst).empty <= allowed || polygons > MAX_POLYGONS) {
                break;
            }
            CellPart part = parts.remove(worst);
            CellPart[] both = part.cut(faces);
            if (both == null) {
                whole.add(part);
            } else {
                parts.addAll(Arrays.asList(both));
            }
        }
        parts.addAll(whole);
    }

    /** Unites the neighbours that add least volume, as long as they are nearly full or there are too many parts. */
    private List<ConvexHull> union() {
        List<ConvexHull> hulls = new ArrayList<>();
        parts.forEach(part -> hulls.add(part.hull));
        List<double[]> boxes = new ArrayList<>();
        hulls.forEach(hull -> boxes.add(bounds(List.of(hull.corners()))));
        List<Pair> pairs = new ArrayList<>();
        for (int i = 0; i < hulls.size(); i++) {
            progress.accept(CUTTING + (1 - CUTTING) * i / hulls.size());
            addPairs(i, hulls, boxes, pairs, i);
        }
        int count = hulls.size();
        while (!pairs.isEmpty()) {
            Pair best = pairs.get(0);
            for (Pair pair : pairs) {
                best = pair.cost < best.cost ? pair : best;
            }
            if (best.cost > ADDED && count <= MAX_PARTS) {
                break;
            }
            Pair merged = best;
            pairs.removeIf(pair -> pair.shares(merged));
            hulls.set(merged.a, merged.hull);
            boxes.set(merged.a, bounds(List.of(merged.hull.corners())));
            hulls.set(merged.b, null);
            count--;
            addPairs(merged.a, hulls, boxes, pairs, hulls.size());
        }
        hulls.removeIf(hull -> hull == null);
        return hulls;
    }

    private void addPairs(int of, List<ConvexHull> hulls, List<double[]> boxes, List<Pair> pairs, int end) {
        boolean all = hulls.size() > MAX_PARTS;
        for (int i = 0; i < end; i++) {
            if (i != of && hulls.get(i) != null && (all || isBeside(boxes.get(of), boxes.get(i)))) {
                pairs.add(new Pair(of, i, hulls.get(of), hulls.get(i)));
            }
        }
    }

    private boolean isBeside(double[] a, double[] b) {
        double near = BESIDE * grid.size;
        for (int axis = 0; axis < 3; axis++) {
            if (a[axis] > b[axis + 3] + near || b[axis] > a[axis + 3] + near) {
                return false;
            }
        }
        return true;
    }

    /** Two parts that may become one. */
    private final class Pair {
        private final int a;
        private final int b;
        private final ConvexHull hull;
        /** Share of volume that the union adds; larger if it has too many empty voxels. */
        private final double cost;

        Pair(int a, int b, ConvexHull one, ConvexHull other) {
            this.a = a;
            this.b = b;
            double[] points = Arrays.copyOf(one.corners(), one.corners().length + other.corners().length);
            System.arraycopy(other.corners(), 0, points, one.corners().length, other.corners().length);
            hull = ConvexHull.of(points, CellPart.CORNERS);
            int empty = CellPart.countVoxels(grid, hull, box(0, points), box(3, points))[1];
            cost = hull.volume() / (one.volume() + other.volume()) - 1
                + (empty > allowed ? ADDED + empty / allowed : 0);
        }

        private int[] box(int end, double[] points) {
            double[] bounds = bounds(List.of(points));
            return new int[] {grid.index(0, bounds[end]), grid.index(1, bounds[end + 1]),
                grid.index(2, bounds[end + 2])};
        }

        boolean shares(Pair other) {
            return a == other.a || a == other.b || b == other.a || b == other.b;
        }
    }
}
