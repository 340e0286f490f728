// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.terrain;

import com.jme3.scene.VertexBuffer;
import com.jme3.util.BufferUtils;

/**
 * Triangle indices of a tile. At the edge to a coarser neighbour, posts that the neighbour lacks collapse to the
 * previous post, so that both share the edge without gaps. There are (4 + 1)^4 index lists of 3 kB, created on demand.
 */
final class TileIndices {
    private static final int SIDE = TilePyramid.CELLS + 1;
    private static final int KINDS = TileChoice.MAX_STEPS + 1;

    private final VertexBuffer[] made = new VertexBuffer[KINDS * KINDS * KINDS * KINDS];

    /** Returns the number of the list for neighbours south, north, west and east that are coarser by these levels. */
    static int kind(int south, int north, int west, int east) {
        return ((south * KINDS + north) * KINDS + west) * KINDS + east;
    }

    VertexBuffer get(int kind) {
        if (made[kind] == null) {
            VertexBuffer buffer = new VertexBuffer(VertexBuffer.Type.Index);
            buffer.setupData(VertexBuffer.Usage.Static, 3, VertexBuffer.Format.UnsignedShort,
                BufferUtils.createShortBuffer(triangles(kind)));
            made[kind] = buffer;
        }
        return made[kind];
    }

    /**
     * Returns three corners per triangle, counter-clockwise from above; corner = row * 17 + column. Omits degenerate
     * triangles.
     */
    static short[] triangles(int kind) {
        short[] corners = new short[6 * TilePyramid.CELLS * TilePyramid.CELLS];
        int next = 0;
        for (int row = 0; row < TilePyramid.CELLS; row++) {
            for (int column = 0; column < TilePyramid.CELLS; column++) {
                int southWest = corner(kind, row, column);
                int northEast = corner(kind, row + 1, column + 1);
                next = add(corners, next, southWest, northEast, corner(kind, row + 1, column));
                next = add(corners, next, southWest, corner(kind, row, column + 1), northEast);
            }
        }
        return java.util.Arrays.copyOf(corners, next);
    }

    private static int add(short[] corners, int next, int a, int b, int c) {
        if (a == b || b == c || a == c) {
            return next;
        }
        corners[next] = (short) a;
        corners[next + 1] = (short) b;
        corners[next + 2] = (short) c;
        return next + 3;
    }

    private static int corner(int kind, int row, int column) {
        int east = kind % KINDS;
        int west = kind / KINDS % KINDS;
        int north = kind / (KINDS * KINDS) % KINDS;
        int south = kind / (KINDS * KINDS * KINDS);
        int r = row;
        int c = column;
        if (row == 0 || row == TilePyramid.CELLS) {
            int steps = row == 0 ? south : north;
            c = column >> steps << steps;
        }
        if (column == 0 || column == TilePyramid.CELLS) {
            int steps = column == 0 ? west : east;
            r = row >> steps << steps;
        }
        return r * SIDE + c;
    }
}
