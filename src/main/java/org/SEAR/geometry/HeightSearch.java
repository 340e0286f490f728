// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import java.util.function.Predicate;

/**
 * Finds the triangles of a {@link HeightGrid} that reach into a box, by pyramids of elevations; allocates only tiles.
 * One thread.
 */
public final class HeightSearch {
    /** Null if one field holds all posts. */
    private final HeightTiles tiles;
    private HeightField field;
    private HeightPyramid pyramid;
    private final float[] corners = new float[9];
    private Predicate<float[]> visitor;
    private double lowX;
    private double lowY;
    private double lowZ;
    private double highX;
    private double highY;
    private double highZ;

    public HeightSearch(HeightGrid grid) {
        tiles = grid instanceof HeightTiles ? (HeightTiles) grid : null;
        if (tiles == null) {
            look((HeightField) grid);
        }
    }

    private void look(HeightField heights) {
        field = heights;
        pyramid = heights.getPyramid();
    }

    /**
     * Visits the triangles whose bounding boxes reach into a box, from south and west within each block.
     * @param low smallest x, metres, likewise the others
     * @param visit takes x, y and z of the three corners, counter-clockwise seen from above, valid only during the
     *     call; true ends the search
     * @return whether a visit ended the search
     */
    public boolean any(double low, double bottom, double west, double high, double top, double east,
        Predicate<float[]> visit) {
        lowX = low;
        lowY = bottom;
        lowZ = west;
        highX = high;
        highY = top;
        highZ = east;
        visitor = visit;
        return tiles == null ? block(pyramid.top, 0, 0, 0) : anyTile();
    }

    /** Searches the tiles whose boxes intersect the box; rounding does not affect which tile has a triangle. */
    private boolean anyTile() {
        int endRow = Math.min(tiles.row(highX) + 1, tiles.rows - 2) / HeightTiles.CELLS;
        int endColumn = Math.min(tiles.column(highZ) + 1, tiles.columns - 2) / HeightTiles.CELLS;
        for (int r = Math.max(0, tiles.row(lowX) - 1) / HeightTiles.CELLS; r <= endRow; r++) {
            for (int c = Math.max(0, tiles.column(lowZ) - 1) / HeightTiles.CELLS; c <= endColumn; c++) {
                int number = r * tiles.tileColumns + c;
                if (intersects(number)) {
                    look(tiles.tile(number));
                    if (block(pyramid.top, 0, 0, 0)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private boolean intersects(int number) {
        return tiles.low(number) <= highY && tiles.high(number) >= lowY
            && tiles.x(tiles.firstRow(number)) <= highX && tiles.x(tiles.lastRow(number)) >= lowX
            && tiles.z(tiles.firstColumn(number)) <= highZ && tiles.z(tiles.lastColumn(number)) >= lowZ;
    }

    private boolean block(int level, int row, int column, int at) {
        int size = 2 << level;
        int endRow = Math.min((row + 1) * size, field.rows - 1);
        int endColumn = Math.min((column + 1) * size, field.columns - 1);
        if (!(pyramid.data[at] <= highY && pyramid.data[at + 1] >= lowY) || field.x(row * size) > highX
            || field.x(endRow) < lowX || field.z(column * size) > highZ || field.z(endColumn) < lowZ) {
            return false;
        }
        if (level > 0) {
            int parts = pyramid.children(level, row, column);
            for (int k = 0; k < 4; k++) {
                if (block(level - 1, 2 * row + k / 2, 2 * column + k % 2, parts + 2 * k)) {
                    return true;
                }
            }
            return false;
        }
        for (int r = row * size; r < endRow; r++) {
            for (int c = column * size; c < endColumn; c++) {
                if (cell(r, c)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean cell(int row, int column) {
        if (field.x(row) > highX || field.x(row + 1) < lowX || field.z(column) > highZ || field.z(column + 1) < lowZ) {
            return false;
        }
        for (int half = 0; half < 2; half++) {
            field.triangle(row, column, half, corners);
            if (Math.min(corners[1], Math.min(corners[4], corners[7])) <= highY
                && Math.max(corners[1], Math.max(corners[4], corners[7])) >= lowY && visitor.test(corners)) {
                return true;
            }
        }
        return false;
    }
}
