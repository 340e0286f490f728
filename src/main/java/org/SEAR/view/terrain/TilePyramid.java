// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.terrain;

import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.geometry.HeightTiles;

/**
 * Drawable squares of ground with their errors. A tile of level l has {@link #CELLS} cells per side, each 2^l cells of
 * the field wide. Cells at the northern and eastern edges may be smaller. Level 0 is the field itself; the last level
 * is a single tile. Memory: about 16 bytes per 256 posts. For ground that exceeds the memory, also every 8th post of
 * every 8th row, which suffices for distant tiles. Window thread only.
 */
final class TilePyramid {
    /** Cells per side of a tile; a power of two. */
    static final int CELLS = 16;

    /** Lowest level whose posts are kept in memory for ground that exceeds the memory. */
    private static final int KEPT = 3;
    /** Distance from the camera, metres, beyond which a tile's minimum replaces the exact elevation. */
    private static final float FAR = 3000;

    final HeightGrid field;
    final int levels;
    /** Maximum deviation of a tile's surface from the field, metres, by level and tile (row by row from the south). */
    private final float[][] errors;
    private final float[][] lows;
    private final float[][] highs;
    /** Kept posts; null if the whole field is in memory. */
    private final float[] kept;
    private final int keptColumns;
    /** The part of the field accessed last, and its south-western post. */
    private HeightField part;
    private int partRow;
    private int partColumn;

    TilePyramid(HeightGrid field) {
        this.field = field;
        boolean whole = field instanceof HeightField;
        part = whole ? (HeightField) field : ((HeightTiles) field).tile(0);
        keptColumns = kept(field.columns - 1) + 1;
        kept = whole ? null : new float[(kept(field.rows - 1) + 1) * keptColumns];
        int count = 1;
        while (rows(field, count - 1) > 1 || columns(field, count - 1) > 1) {
            count++;
        }
        levels = count;
        errors = new float[levels][];
        lows = new float[levels][];
        highs = new float[levels][];
        for (int level = 0; level < levels; level++) {
            errors[level] = new float[rows(level) * columns(level)];
            lows[level] = new float[errors[level].length];
            highs[level] = new float[errors[level].length];
        }
        if (kept != null) {
            fill((HeightTiles) field);
        }
        for (int level = kept == null ? 0 : KEPT + 1; level < levels; level++) {
            fill(level, 0, rows(level), 0, columns(level));
        }
    }

    /** Fills the tiles of this pyramid inside each tile of the ground. */
    private void fill(HeightTiles tiles) {
        for (int number = 0; number < tiles.size(); number++) {
            int south = tiles.firstRow(number);
            int west = tiles.firstColumn(number);
            look(tiles, number);
            for (int level = 0; level < Math.min(levels, KEPT + 1); level++) {
                int size = CELLS << level;
                fill(level, south / size, (tiles.lastRow(number) - 1) / size + 1, west / size,
                    (tiles.lastColumn(number) - 1) / size + 1);
            }
            for (int r = kept(south); r <= kept(tiles.lastRow(number)); r++) {
                for (int c = kept(west); c <= kept(tiles.lastColumn(number)); c++) {
                    kept[r * keptColumns + c] = part.y(Math.min((r << KEPT) - south, part.rows - 1),
                        Math.min((c << KEPT) - west, part.columns - 1));
                }
            }
        }
    }

    private void fill(int level, int row, int endRow, int column, int endColumn) {
        for (int r = row; r < endRow; r++) {
            for (int c = column; c < endColumn; c++) {
                fill(level, r, c);
            }
        }
    }

    private static int kept(int post) {
        return (post + (1 << KEPT) - 1) >> KEPT;
    }

    private void look(HeightTiles tiles, int number) {
        part = tiles.tile(number);
        partRow = tiles.firstRow(number);
        partColumn = tiles.firstColumn(number);
    }

    /**
     * Returns the elevation of a post, metres.
     * @param level of a tile that contains it
     */
    float y(int level, int row, int column) {
        if (kept != null && level >= KEPT) {
            return kept[kept(row) * keptColumns + kept(column)];
        }
        int r = row - partRow;
        int c = column - partColumn;
        if (r < 0 || c < 0 || r >= part.rows || c >= part.columns) {
            HeightTiles tiles = (HeightTiles) field;
            look(tiles, Math.min(row / HeightTiles.CELLS, tiles.tileRows - 1) * tiles.tileColumns
                + Math.min(column / HeightTiles.CELLS, tiles.tileColumns - 1));
            return part.y(row - partRow, column - partColumn);
        }
        return part.y(r, c);
    }

    /**
     * Returns a lower bound of the ground's elevation, metres; NaN outside. The bound is exact except far from the
     * camera on ground that exceeds the memory.
     */
    double surely(float x, float z, float distance) {
        if (kept == null || distance < FAR) {
            return field.height(x, z);
        }
        int row = (int) Math.floor((x - field.lowX) / field.spacingX / CELLS);
        int column = (int) Math.floor((z - field.lowZ) / field.spacingZ / CELLS);
        return row < 0 || column < 0 || row >= rows(0) || column >= columns(0) ? Double.NaN : low(0, row, column);
    }

    private static int rows(HeightGrid field, int level) {
        return tiles(field.rows - 1, level);
    }

    private static int columns(HeightGrid field, int level) {
        return tiles(field.columns - 1, level);
    }

    private static int tiles(int cells, int level) {
        return (int) ((cells - 1L) / ((long) CELLS << level)) + 1;
    }

    /** Returns the number of rows of tiles, from south to north. */
    int rows(int level) {
        return rows(field, level);
    }

    /** Returns the number of columns of tiles, from west to east. */
    int columns(int level) {
        return columns(field, level);
    }

    /** Returns the maximum deviation of a tile, metres. */
    float error(int level, int row, int column) {
        return errors[level][row * columns(level) + column];
    }

    /** Returns the minimum elevation of a tile, metres. */
    float low(int level, int row, int column) {
        return lows[level][row * columns(level) + column];
    }

    /** Returns the maximum elevation of a tile, metres. */
    float high(int level, int row, int column) {
        return highs[level][row * columns(level) + column];
    }

    /**
     * Returns the row of posts that is cell cells of a tile north of its southern edge, limited to the field's last
     * row.
     */
    int postRow(int level, int row, int cell) {
        return (int) Math.min(field.rows - 1, ((long) row * CELLS + cell) << level);
    }

    /** Returns the column of posts, counted from the tile's western edge. */
    int postColumn(int level, int column, int cell) {
        return (int) Math.min(field.columns - 1, ((long) column * CELLS + cell) << level);
    }

    private void fill(int level, int row, int column) {
        float low = Float.POSITIVE_INFINITY;
        float high = Float.NEGATIVE_INFINITY;
        float error = 0;
        if (level == 0) {
            for (int r = postRow(0, row, 0); r <= postRow(0, row, CELLS); r++) {
                for (int c = postColumn(0, column, 0); c <= postColumn(0, column, CELLS); c++) {
                    float height = y(0, r, c);
                    low = Math.min(low, height);
                    high = Math.max(high, height);
                }
            }
        } else {
            for (int r = 2 * row; r < Math.min(rows(level - 1), 2 * row + 2); r++) {
                for (int c = 2 * column; c < Math.min(columns(level - 1), 2 * column + 2); c++) {
                    low = Math.min(low, low(level - 1, r, c));
                    high = Math.max(high, high(level - 1, r, c));
                    error = Math.max(error, error(level - 1, r, c));
                }
            }
            error += step(level, row, column);
        }
        int at = row * columns(level) + column;
        lows[level][at] = low;
        highs[level][at] = high;
        errors[level][at] = error;
    }

    /** Returns a tile's maximum deviation from the tiles one level below, metres. */
    private float step(int level, int row, int column) {
        float most = 0;
        for (int i = 0; i < CELLS; i++) {
            for (int j = 0; j < CELLS; j++) {
                most = Math.max(most, step(level - 1, postRow(level, row, i), postRow(level, row, i + 1),
                    postColumn(level, column, j), postColumn(level, column, j + 1)));
            }
        }
        return most;
    }

    /**
     * Returns the maximum deviation of a cell's intermediate posts, which the level below adds, from the cell's two
     * triangles, metres.
     */
    private float step(int below, int south, int north, int west, int east) {
        int half = 1 << below;
        float most = 0;
        for (int r = south; r <= north; r = r < south + half && south + half < north ? south + half : r < north
            ? north : north + 1) {
            for (int c = west; c <= east; c = c < west + half && west + half < east ? west + half : c < east
                ? east : east + 1) {
                most = Math.max(most, Math.abs(y(below, r, c) - surface(below, south, north, west, east, r, c)));
            }
        }
        return most;
    }

    private float surface(int level, int south, int north, int west, int east, int r, int c) {
        float u = north > south ? (float) (r - south) / (north - south) : 0;
        float v = east > west ? (float) (c - west) / (east - west) : 0;
        float low = y(level, south, west);
        float high = y(level, north, east);
        if (v >= u) {
            float corner = y(level, south, east);
            return low + v * (corner - low) + u * (high - corner);
        }
        float corner = y(level, north, west);
        return low + u * (corner - low) + v * (high - corner);
    }
}
