package org.SEAR.view.terrain;

import com.jme3.scene.VertexBuffer;
import com.jme3.util.BufferUtils;

/**
 * The triangles of a tile between its posts. Where a neighbour is coarser, posts on the common edge that it lacks are drawn together with the one
 * before them, so that both have the same edge and no hole is left. There are (4 + 1)^4 such lists of 3 kB; those that are used are made once.
 */
final class TileIndices {
    private static final int SIDE = TilePyramid.CELLS + 1;
    private static final int KINDS = TileChoice.MAX_STEPS + 1;

    private final VertexBuffer[] made = new VertexBuffer[KINDS * KINDS * KINDS * KINDS];

    /** The number of a list: by how many levels the neighbours south, north, west and east are coarser. */
    static int kind(int south, int north, int west, int east) {
        return ((south * KINDS + north) * KINDS + west) * KINDS + east;
    }

    VertexBuffer get(int kind) {
        if (made[kind] == null) {
            VertexBuffer buffer = new VertexBuffer(VertexBuffer.Type.Index);
            buffer.setupData(VertexBuffer.Usage.Static, 3, VertexBuffer.Format.UnsignedShort, BufferUtils.createShortBuffer(triangles(kind)));
            made[kind] = buffer;
        }
        return made[kind];
    }

    /** Three corners a triangle, counter-clockwise from above; corner = row * 17 + column. Triangles without area are left out. */
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
