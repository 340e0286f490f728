// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightPyramid;

/**
 * Cuts a {@link HeightField} with a fan's plane. Descends the min/max pyramid (maximum mipmaps: Tevs, Ihrke and Seidel,
 * "Maximum mipmaps for fast, accurate, and scalable dynamic height field rendering", 2008) through the blocks that the
 * plane intersects, nearer ones first. One thread.
 */
final class FanHeights {
    /** Level whose blocks are cut cell by cell. */
    private static final int LEAF = 1;
    /** Bits of row and of column in a block's number; the level is above them. */
    private static final int ROW = 28;
    private static final int MASK = (1 << ROW) - 1;

    /** Number of blocks and triangles that the last {@link #cast} visited. */
    int nodes;
    int triangles;

    private final PlaneCut plane;
    private final CellCut cells;
    private final CutStack stack;
    private HeightField field;
    private HeightPyramid pyramid;
    /** Maximum deviation of a post from its row or column through rounding to float, metres. */
    private double roundX;
    private double roundZ;
    /** The fan's origin, by which the nearest children of blocks are found. */
    private double originX;
    private double originZ;

    FanHeights(DepthBuffer depth, TriangleCut cut) {
        plane = cut.plane;
        cells = new CellCut(depth, cut);
        stack = new CutStack(depth, plane);
    }

    /**
     * Intersects the field, after {@link TriangleCut#start}.
     * @param originOfX origin of the fan in the field's frame, likewise originOfZ
     */
    void cast(HeightField heights, double originOfX, double originOfZ, double maxRange) {
        field = heights;
        pyramid = heights.getPyramid();
        originX = originOfX;
        originZ = originOfZ;
        nodes = 0;
        triangles = 0;
        double farX = Math.max(Math.abs(heights.x(0)), Math.abs(heights.x(heights.rows - 1)));
        double farZ = Math.max(Math.abs(heights.z(0)), Math.abs(heights.z(heights.columns - 1)));
        roundX = Math.ulp((float) farX);
        roundZ = Math.ulp((float) farZ);
        plane.ready(farX, Math.max(Math.abs(pyramid.lowest()), Math.abs(pyramid.highest())), farZ, maxRange);
        stack.start();
        push(pyramid.top, 0, 0, 0);
        for (long block = stack.pop(); block >= 0; block = stack.pop()) {
            nodes++;
            int level = (int) (block >> 2 * ROW);
            int row = (int) (block >> ROW) & MASK;
            int column = (int) block & MASK;
            if (level > LEAF) {
                open(level, row, column);
            } else if (stack.around) {
                triangles += cells.intersectAll(heights, CellCut.CELLS * row, CellCut.CELLS * column);
            } else {
                triangles += cells.intersect(heights, CellCut.CELLS * row, CellCut.CELLS * column, stack.first,
                    stack.last);
            }
        }
    }

    /** Pushes the children of a block that the plane intersects within the range, the nearest last. */
    private void open(int level, int row, int column) {
        int near = (originX >= middle(field.lowX, field.spacingX, level, row) ? 2 : 0)
            + (originZ >= middle(field.lowZ, field.spacingZ, level, column) ? 1 : 0);
        int at = pyramid.children(level, row, column);
        for (int k = 3; k >= 0; k--) {
            int part = near ^ k;
            push(level - 1, 2 * row + (part >> 1), 2 * column + (part & 1), at + 2 * part);
        }
    }

    private static double middle(double low, double spacing, int level, int number) {
        return low + (2 * number + 1) * (1 << level) * spacing;
    }

    private void push(int level, int row, int column, int at) {
        double low = pyramid.data[at];
        double halfY = (pyramid.data[at + 1] - low) / 2;
        if (plane.intersects(middle(field.lowX, field.spacingX, level, row), low + halfY,
            middle(field.lowZ, field.spacingZ, level, column),
            (1 << level) * field.spacingX + roundX, halfY, (1 << level) * field.spacingZ + roundZ)) {
            stack.push((long) level << 2 * ROW | (long) row << ROW | column);
        }
    }
}
