// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * Ground too large for the memory: square tiles, each a {@link HeightField}, with a cache of the most recently used
 * ones. The thread that needs a missing tile makes it immediately. A tile is the same to the bit each time, so results
 * do not depend on the cache. Neighbours both hold their common posts. Any thread.
 */
public final class HeightTiles extends HeightGrid {
    /** Cells on each side of a tile; those at the northern and eastern ends may have fewer. */
    public static final int CELLS = 128;
    /** Largest number of cached tiles; with the elevation ranges of their blocks they take 0.11 MB each. */
    public static final int MAX_HELD = 2048;
    /** Memory of a tile, bytes. */
    private static final long TILE = 112_000;
    /** Tiles take at most one part in this many of Java's heap. */
    private static final int SHARE = 4;
    private static final int MIN_HELD = 64;
    /** Rows, columns and positions are multiples of 1 / EXACT metres, so that all sums are exact. */
    private static final double EXACT = 1 << 24;

    /** From south to north. */
    public final int tileRows;
    /** From west to east. */
    public final int tileColumns;
    private final Source source;
    private final int most;
    private final float[] lows;
    private final float[] highs;
    private final float lowest;
    private final float highest;
    private final AtomicReferenceArray<HeightField> held;
    /** Time of each tile's last use: twice the number of tiles made by then, minus one if it was made then. */
    private final AtomicLongArray used;
    private int count;
    private volatile long made;

    /** Source of elevations. Any thread. */
    public interface Source {
        /**
         * Returns the elevations of posts, metres, row by row from the south, each from the west; the same each time.
         * @param row the first one, likewise column
         * @param width number of columns, likewise height of rows
         */
        float[] heights(int row, int column, int height, int width);
    }

    /** Visits each tile once. */
    public interface Visitor {
        /**
         * Visits a tile, in the grid's frame.
         * @param row its first row of posts in the grid, likewise column
         */
        void see(HeightField tile, int row, int column);
    }

    /**
     * Reads all tiles once, row by row from the south, to find their elevation ranges.
     * @param lowX metres, and likewise lowZ and the spacings: as {@link #exact} makes them
     * @param most largest number of cached tiles
     * @param visitor visits each tile
     */
    public HeightTiles(int rows, int columns, double lowX, double lowZ, double spacingX, double spacingZ, Source source,
        int most, Visitor visitor) {
        super(rows, columns, lowX, lowZ, spacingX, spacingZ);
        if (exact(lowX) != lowX || exact(lowZ) != lowZ || exact(spacingX) != spacingX || exact(spacingZ) != spacingZ
            || most < 1) {
            throw new IllegalArgumentException("height tiles: from " + lowX + ", " + lowZ + " on, " + spacingX + " and "
                + spacingZ + " m apart, "
                + most + " held, legal: numbers of metres with at most 24 binary places, at least 1 held");
        }
        this.source = source;
        this.most = most;
        tileRows = (rows - 2) / CELLS + 1;
        tileColumns = (columns - 2) / CELLS + 1;
        lows = new float[tileRows * tileColumns];
        highs = new float[tileRows * tileColumns];
        held = new AtomicReferenceArray<>(tileRows * tileColumns);
        used = new AtomicLongArray(tileRows * tileColumns);
        float least = Float.POSITIVE_INFINITY;
        float greatest = Float.NEGATIVE_INFINITY;
        for (int number = 0; number < lows.length; number++) {
            HeightField tile = make(number);
            survey(number, tile.heights);
            least = Math.min(least, lows[number]);
            greatest = Math.max(greatest, highs[number]);
            visitor.see(tile, firstRow(number), firstColumn(number));
        }
        lowest = least;
        highest = greatest;
    }

    /** Returns the nearest length at which rows and columns of neighbouring tiles agree to the bit, metres. */
    public static double exact(double metres) {
        return Math.rint(metres * EXACT) / EXACT;
    }

    /** Returns the size of the cache in tiles: {@link #MAX_HELD}, or as many as fit into a quarter of Java's heap. */
    public static int room() {
        return (int) Math.max(MIN_HELD, Math.min(MAX_HELD, Runtime.getRuntime().maxMemory() / SHARE / TILE));
    }

    private void survey(int number, float[] heights) {
        float least = Float.POSITIVE_INFINITY;
        float greatest = Float.NEGATIVE_INFINITY;
        for (float height : heights) {
            least = height < least ? height : least;
            greatest = height > greatest ? height : greatest;
        }
        lows[number] = least;
        highs[number] = greatest;
    }

    /** Number of tiles; they are numbered row by row from the south, each from the west. */
    public int size() {
        return lows.length;
    }

    /** First row of posts of a tile. */
    public int firstRow(int number) {
        return number / tileColumns * CELLS;
    }

    /** First column of posts of a tile. */
    public int firstColumn(int number) {
        return number % tileColumns * CELLS;
    }

    /** Last row of posts of a tile. */
    public int lastRow(int number) {
        return Math.min(firstRow(number) + CELLS, rows - 1);
    }

    /** Last column of posts of a tile. */
    public int lastColumn(int number) {
        return Math.min(firstColumn(number) + CELLS, columns - 1);
    }

    /** Lowest elevation in a tile, metres. */
    public float low(int number) {
        return lows[number];
    }

    /** Highest elevation in a tile, metres. */
    public float high(int number) {
        return highs[number];
    }

    /** Returns a tile, in the grid's frame. */
    public HeightField tile(int number) {
        HeightField tile = held.get(number);
        if (tile == null) {
            return load(number);
        }
        long now = 2 * made;
        if (used.get(number) != now) {
            used.set(number, now);
        }
        return tile;
    }

    private synchronized HeightField load(int number) {
        HeightField tile = held.get(number);
        if (tile == null) {
            if (count == most) {
                held.set(oldest(), null);
                count--;
            }
            tile = make(number);
            long next = made + 1;
            made = next;
            used.set(number, 2 * next - 1);
            count++;
            held.set(number, tile);
        }
        return tile;
    }

    private int oldest() {
        int oldest = -1;
        for (int i = 0; i < held.length(); i++) {
            if (held.get(i) != null && (oldest < 0 || used.get(i) < used.get(oldest))) {
                oldest = i;
            }
        }
        return oldest;
    }

    private HeightField make(int number) {
        int row = firstRow(number);
        int column = firstColumn(number);
        int height = lastRow(number) - row + 1;
        int width = lastColumn(number) - column + 1;
        return new HeightField(height, width, lowX + row * spacingX, lowZ + column * spacingZ, spacingX, spacingZ,
            source.heights(row, column, height, width));
    }

    /** Number of tiles made since the first reading: a measure of work. */
    public long made() {
        return made;
    }

    /** Number of cached tiles. */
    public synchronized int held() {
        return count;
    }

    @Override
    public float y(int row, int column) {
        int r = Math.min(row / CELLS, tileRows - 1);
        int c = Math.min(column / CELLS, tileColumns - 1);
        return tile(r * tileColumns + c).y(row - r * CELLS, column - c * CELLS);
    }

    @Override
    public double height(double x, double z) {
        return has(x, z) ? tile(row(x) / CELLS * tileColumns + column(z) / CELLS).height(x, z) : Double.NaN;
    }

    @Override
    public float lowest() {
        return lowest;
    }

    @Override
    public float highest() {
        return highest;
    }
}
