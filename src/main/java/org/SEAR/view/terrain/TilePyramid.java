package org.SEAR.view.terrain;

import org.SEAR.geometry.HeightField;

/**
 * The squares of a height field that can be drawn, and how wrong each would be. A tile of level l has {@link #CELLS} cells on each side, of 2^l of
 * the field's cells each; at the field's northern and eastern ends cells are cut short. Level 0 is the very field; the last level is one tile.
 * Holds about 16 bytes for each 256 posts. Immutable once made.
 */
final class TilePyramid {
    /** Cells on each side of a tile: a power of two. */
    static final int CELLS = 16;

    final HeightField field;
    final int levels;
    /** By level and tile (row by row from the south): metres by which the tile's surface is off the field's at most. */
    private final float[][] errors;
    private final float[][] lows;
    private final float[][] highs;

    TilePyramid(HeightField field) {
        this.field = field;
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
            for (int row = 0; row < rows(level); row++) {
                for (int column = 0; column < columns(level); column++) {
                    fill(level, row, column);
                }
            }
        }
    }

    private static int rows(HeightField field, int level) {
        return tiles(field.rows - 1, level);
    }

    private static int columns(HeightField field, int level) {
        return tiles(field.columns - 1, level);
    }

    private static int tiles(int cells, int level) {
        return (int) ((cells - 1L) / ((long) CELLS << level)) + 1;
    }

    /** Rows of tiles, from south to north. */
    int rows(int level) {
        return rows(field, level);
    }

    /** Columns of tiles, from west to east. */
    int columns(int level) {
        return columns(field, level);
    }

    /** Metres. */
    float error(int level, int row, int column) {
        return errors[level][row * columns(level) + column];
    }

    /** The lowest height in a tile, metres. */
    float low(int level, int row, int column) {
        return lows[level][row * columns(level) + column];
    }

    /** The highest height in a tile, metres. */
    float high(int level, int row, int column) {
        return highs[level][row * columns(level) + column];
    }

    /** The row of posts that is so many of a tile's cells from its southern edge; the field's last row beyond that. */
    int postRow(int level, int row, int cell) {
        return (int) Math.min(field.rows - 1, ((long) row * CELLS + cell) << level);
    }

    /** Likewise for columns, from its western edge. */
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
                    low = Math.min(low, field.y(r, c));
                    high = Math.max(high, field.y(r, c));
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

    /** How far a tile is off the tiles of the level below, metres. */
    private float step(int level, int row, int column) {
        float most = 0;
        for (int i = 0; i < CELLS; i++) {
            for (int j = 0; j < CELLS; j++) {
                most = Math.max(most, step(postRow(level, row, i), postRow(level, row, i + 1), postColumn(level, column, j),
                    postColumn(level, column, j + 1), 1 << level - 1));
            }
        }
        return most;
    }

    /** How far the posts that the level below has in a cell between those at its corners are off its two triangles. */
    private float step(int south, int north, int west, int east, int half) {
        float most = 0;
        for (int r = south; r <= north; r = r < south + half && south + half < north ? south + half : r < north ? north : north + 1) {
            for (int c = west; c <= east; c = c < west + half && west + half < east ? west + half : c < east ? east : east + 1) {
                most = Math.max(most, Math.abs(field.y(r, c) - surface(south, north, west, east, r, c)));
            }
        }
        return most;
    }

    private float surface(int south, int north, int west, int east, int r, int c) {
        float u = north > south ? (float) (r - south) / (north - south) : 0;
        float v = east > west ? (float) (c - west) / (east - west) : 0;
        float low = field.y(south, west);
        float high = field.y(north, east);
        if (v >= u) {
            float corner = field.y(south, east);
            return low + v * (corner - low) + u * (high - corner);
        }
        float corner = field.y(north, west);
        return low + u * (corner - low) + v * (high - corner);
    }
}
