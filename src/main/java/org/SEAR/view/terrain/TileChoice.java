// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.terrain;

import com.jme3.math.FastMath;
import com.jme3.math.Plane;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import java.util.Arrays;

/**
 * Chooses tiles that cover the field exactly once, each as coarse as unnoticeable (chunked level of detail: Ulrich,
 * "Rendering massive terrains using chunked level of detail control", 2002). A tile is chosen if its error appears
 * smaller than a few pixels; otherwise its four children are visited. If too many tiles are visible, the tolerance
 * grows. Allocates nothing per frame.
 */
final class TileChoice {
    /** Maximum difference of levels between neighbours, limited by the cells on a tile's edge. */
    static final int MAX_STEPS = Integer.numberOfTrailingZeros(TilePyramid.CELLS);
    /** Error tolerance of distant ground, pixels. */
    private static final float FAR_PIXELS = 1.5f;
    /** Error tolerance of near ground, where objects stand, pixels. */
    private static final float NEAR_PIXELS = 0.25f;
    /** Margin, pixels, by which ground must be below the horizon to be hidden, in addition to the tolerances. */
    private static final float SURELY = 3;
    private static final float NEAR = 20;
    private static final float FAR = 120;
    private static final float COARSER = 1.25f;
    private static final float FINER = 0.97f;
    /** Share of the maximum number of tiles below which the ground becomes finer again. */
    private static final float ROOM = 0.75f;

    private final TilePyramid pyramid;
    private final int most;
    private final Horizon horizon;
    private final byte[] levels;
    private final boolean[][] forced;
    private final Plane[] sides = new Plane[4];
    private final Vector3f eye = new Vector3f();
    /** Level, row, column and visibility of each chosen tile. */
    private int[] chosen = new int[1024];
    private int count;
    private int seen;
    private float pixels;
    private float tolerance = 1;

    /** @param most maximum number of visible tiles */
    TileChoice(TilePyramid pyramid, int most) {
        this.pyramid = pyramid;
        this.most = most;
        horizon = new Horizon(pyramid, pyramid.high(pyramid.levels - 1, 0, 0));
        levels = new byte[pyramid.rows(0) * pyramid.columns(0)];
        forced = new boolean[pyramid.levels][];
        for (int level = 0; level < pyramid.levels; level++) {
            forced[level] = new boolean[pyramid.rows(level) * pyramid.columns(level)];
        }
    }

    /** Chooses the tiles for a camera. */
    void choose(Camera camera) {
        for (int side = 0; side < sides.length; side++) {
            sides[side] = camera.getWorldPlane(side); // left, right, bottom, top
        }
        eye.set(camera.getLocation());
        pixels = camera.getHeight() * camera.getFrustumNear() / (camera.getFrustumTop() - camera.getFrustumBottom());
        horizon.look(camera);
        tolerance = Math.max(1, seen < ROOM * most ? tolerance * FINER : tolerance);
        pass();
        while (seen > most && count > 1) {
            tolerance *= COARSER;
            pass();
        }
    }

    private void pass() {
        boolean again = true;
        while (again) {
            count = 0;
            seen = 0;
            visit(pyramid.levels - 1, 0, 0);
            again = split();
        }
        for (boolean[] level : forced) {
            Arrays.fill(level, false);
        }
    }

    private void visit(int level, int row, int column) {
        boolean visible = isVisible(level, row, column);
        if (level > 0 && (forced[level][row * pyramid.columns(level) + column] || visible
            && isCoarse(level, row, column))) {
            int rows = Math.min(pyramid.rows(level - 1), 2 * row + 2);
            int columns = Math.min(pyramid.columns(level - 1), 2 * column + 2);
            for (int r = 2 * row; r < rows; r++) {
                for (int c = 2 * column; c < columns; c++) {
                    visit(level - 1, r, c);
                }
            }
            return;
        }
        if (4 * count == chosen.length) {
            chosen = Arrays.copyOf(chosen, 2 * chosen.length);
        }
        chosen[4 * count] = level;
        chosen[4 * count + 1] = row;
        chosen[4 * count + 2] = column;
        chosen[4 * count + 3] = visible ? 1 : 0;
        count++;
        seen += visible ? 1 : 0;
        paint(level, row, column);
    }

    private void paint(int level, int row, int column) {
        int width = pyramid.columns(0);
        int west = column << level;
        int east = Math.min(width, column + 1 << level);
        for (int r = row << level; r < Math.min(pyramid.rows(0), row + 1 << level); r++) {
            Arrays.fill(levels, r * width + west, r * width + east, (byte) level);
        }
    }

    /** Returns whether a tile's error exceeds the tolerance. */
    private boolean isCoarse(int level, int row, int column) {
        float distance = distance(level, row, column);
        float far = FastMath.clamp((distance - NEAR) / (FAR - NEAR), 0, 1);
        float allowed = NEAR_PIXELS + far * (FAR_PIXELS * tolerance - NEAR_PIXELS);
        return pyramid.error(level, row, column) * pixels > allowed * distance;
    }

    private float distance(int level, int row, int column) {
        float x = beside(eye.x, south(level, row), south(level, row + 1));
        float z = beside(eye.z, west(level, column), west(level, column + 1));
        float y = beside(eye.y, pyramid.low(level, row, column), pyramid.high(level, row, column));
        return FastMath.sqrt(x * x + y * y + z * z);
    }

    private static float beside(float value, float low, float high) {
        return Math.max(0, Math.max(low - value, value - high));
    }

    private float south(int level, int row) {
        return pyramid.field.x(pyramid.postRow(level, row, 0));
    }

    private float west(int level, int column) {
        return pyramid.field.z(pyramid.postColumn(level, column, 0));
    }

    /** Returns whether a part of a tile's box may be in the view, at any distance, and not hidden by nearer ground. */
    private boolean isVisible(int level, int row, int column) {
        for (Plane side : sides) {
            Vector3f inward = side.getNormal();
            float x = inward.x > 0 ? south(level, row + 1) : south(level, row);
            float y = inward.y > 0 ? pyramid.high(level, row, column) : pyramid.low(level, row, column);
            float z = inward.z > 0 ? west(level, column + 1) : west(level, column);
            if (inward.x * x + inward.y * y + inward.z * z < side.getConstant()) {
                return false;
            }
        }
        return !horizon.hides(south(level, row), south(level, row + 1), west(level, column), west(level, column + 1),
            pyramid.high(level, row, column), (SURELY + FAR_PIXELS * tolerance) / pixels);
    }

    /** Marks tiles that are too coarse for a neighbour. */
    private boolean split() {
        boolean found = false;
        for (int i = 0; i < count; i++) {
            for (int side = 0; side < 4; side++) {
                if (coarser(i, side) > MAX_STEPS) {
                    int level = neighbour(i, side);
                    int at = (neighbourRow(i, side) >> level) * pyramid.columns(level)
                        + (neighbourColumn(i, side) >> level);
                    forced[level][at] = true;
                    found = true;
                }
            }
        }
        return found;
    }

    /** Returns the number of chosen tiles. */
    int count() {
        return count;
    }

    int level(int tile) {
        return chosen[4 * tile];
    }

    int row(int tile) {
        return chosen[4 * tile + 1];
    }

    int column(int tile) {
        return chosen[4 * tile + 2];
    }

    boolean isSeen(int tile) {
        return chosen[4 * tile + 3] == 1;
    }

    /** Returns the number of visible tiles. */
    int seen() {
        return seen;
    }

    /** Returns the distance from the camera to a tile, metres. */
    float distance(int tile) {
        return distance(level(tile), row(tile), column(tile));
    }

    /**
     * Returns by how many levels the neighbour at a side is coarser; 0 if it isn't, or without a neighbour.
     * @param side 0 south, 1 north, 2 west, 3 east
     */
    int coarser(int tile, int side) {
        return Math.max(0, neighbour(tile, side) - level(tile));
    }

    /** Returns the level of a neighbour, or -1 at the field's edge. */
    private int neighbour(int tile, int side) {
        int row = neighbourRow(tile, side);
        int column = neighbourColumn(tile, side);
        boolean inside = row >= 0 && row < pyramid.rows(0) && column >= 0 && column < pyramid.columns(0);
        return inside ? levels[row * pyramid.columns(0) + column] : -1;
    }

    private int neighbourRow(int tile, int side) {
        int row = row(tile) << level(tile);
        return side == 0 ? row - 1 : side == 1 ? row + (1 << level(tile)) : row;
    }

    private int neighbourColumn(int tile, int side) {
        int column = column(tile) << level(tile);
        return side == 2 ? column - 1 : side == 3 ? column + (1 << level(tile)) : column;
    }
}
