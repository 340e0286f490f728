// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.Arrays;
import java.util.List;

/**
 * Voxels of a mesh: those that its triangles touch, and those that the triangles shut off from outside. The centres of
 * the outermost voxels are on the mesh's bounds. Immutable.
 */
final class VoxelGrid {
    private static final int VOXELS = 200_000;
    /** Largest number of voxels along an axis. */
    private static final int MOST = 128;
    /** Largest number of rows of voxels that triangles may cross; with more, voxels are larger. */
    private static final double MAX_ROWS = 2e7;
    private static final byte SURFACE = 1;
    private static final byte OUTSIDE = 2;

    /** Edge of a voxel, metres. */
    final double size;
    /** Number of voxels along each axis. */
    final int[] count = new int[3];
    /** Lower corner of the first voxel, metres. */
    final double[] low = new double[3];
    private final byte[] states;

    /** @param polygons x, y, z of the corners of each, metres */
    VoxelGrid(List<double[]> polygons, double[] least, double[] most) {
        double edge = edge(least, most);
        while (rows(polygons, edge) > MAX_ROWS) {
            edge *= 2;
        }
        size = edge;
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = least[axis] - size / 2;
            count[axis] = (int) ((most[axis] - least[axis]) / size + 0.5) + 1;
        }
        states = new byte[count[0] * count[1] * count[2]];
        polygons.forEach(this::mark);
        flood();
    }

    private static double edge(double[] least, double[] most) {
        double longest = Math.max(Math.max(most[0] - least[0], most[1] - least[1]), most[2] - least[2]);
        double volume = 1;
        for (int axis = 0; axis < 3; axis++) {
            volume *= Math.max(most[axis] - least[axis], longest / MOST);
        }
        return Math.max(Math.cbrt(volume / VOXELS), longest / (MOST - 1));
    }

    private static double rows(List<double[]> polygons, double edge) {
        double rows = 0;
        for (double[] polygon : polygons) {
            double[] range = new double[6];
            ClippedPolygon.bounds(polygon, range);
            rows += ((range[4] - range[1]) / edge + 1) * ((range[5] - range[2]) / edge + 1);
        }
        return rows;
    }

    /** Index along an axis of the voxel at a coordinate. */
    int index(int axis, double at) {
        return Math.max(0, Math.min(count[axis] - 1, (int) ((at - low[axis]) / size)));
    }

    /** Coordinate of a voxel's centre along an axis, metres. */
    double centre(int axis, int index) {
        return low[axis] + (index + 0.5) * size;
    }

    private int at(int i, int j, int k) {
        return (k * count[1] + j) * count[0] + i;
    }

    private void mark(double[] polygon) {
        double[] range = new double[6];
        ClippedPolygon.bounds(polygon, range);
        int top = index(2, range[5]);
        for (int k = index(2, range[2]); k <= top; k++) {
            double[] layer = slab(polygon, 2, k);
            if (layer == null) {
                continue;
            }
            ClippedPolygon.bounds(layer, range);
            int last = index(1, range[4]);
            for (int j = index(1, range[1]); j <= last; j++) {
                double[] row = slab(layer, 1, j);
                if (row != null) {
                    ClippedPolygon.bounds(row, range);
                    Arrays.fill(states, at(index(0, range[0]), j, k), at(index(0, range[3]), j, k) + 1, SURFACE);
                }
            }
        }
    }

    private double[] slab(double[] polygon, int axis, int index) {
        double from = low[axis] + index * size;
        double[] above = ClippedPolygon.clip(polygon, axis, from, -1, 0);
        return above == null ? null : ClippedPolygon.clip(above, axis, from + size, 1, 0);
    }

    /** Marks what is connected with the bounds and not surface as outside. */
    private void flood() {
        int[] stack = new int[states.length];
        int top = 0;
        for (int k = 0; k < count[2]; k++) {
            for (int j = 0; j < count[1]; j++) {
                boolean rim = k == 0 || k == count[2] - 1 || j == 0 || j == count[1] - 1;
                for (int i = 0; i < count[0]; i += rim || count[0] == 1 ? 1 : count[0] - 1) {
                    top = visit(at(i, j, k), stack, top);
                }
            }
        }
        while (top > 0) {
            int voxel = stack[--top];
            int i = voxel % count[0];
            int j = voxel / count[0] % count[1];
            int k = voxel / count[0] / count[1];
            top = i > 0 ? visit(voxel - 1, stack, top) : top;
            top = i < count[0] - 1 ? visit(voxel + 1, stack, top) : top;
            top = j > 0 ? visit(voxel - count[0], stack, top) : top;
            top = j < count[1] - 1 ? visit(voxel + count[0], stack, top) : top;
            top = k > 0 ? visit(voxel - count[0] * count[1], stack, top) : top;
            top = k < count[2] - 1 ? visit(voxel + count[0] * count[1], stack, top) : top;
        }
    }

    private int visit(int voxel, int[] stack, int top) {
        if (states[voxel] != 0) {
            return top;
        }
        states[voxel] = OUTSIDE;
        stack[top] = voxel;
        return top + 1;
    }

    /** Whether a voxel belongs to the solid or its surface. */
    boolean isSolid(int i, int j, int k) {
        return states[at(i, j, k)] != OUTSIDE;
    }

    /** Whether a whole voxel is inside the solid. */
    boolean isInside(int i, int j, int k) {
        return states[at(i, j, k)] == 0;
    }
}
