package org.SEAR.geometry;

import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * Ground that is too large for the memory: square tiles, each a {@link HeightField} of its own, of which those that were used last are held. A tile
 * that is needed is made then and there by the thread that needs it, the same to the bit each time, so nothing depends on which tiles are held.
 * Neighbours have their common posts both. Any thread.
 */
public final class HeightTiles extends HeightGrid {
    /** Cells on each side of a tile; those at the northern and eastern ends may have fewer. */
    public static final int CELLS = 128;
    /** Tiles that are held at most; with the least and greatest heights of their blocks they take 0.11 MB each. */
    public static final int MAX_HELD = 2048;
    /** What one takes then, bytes. */
    private static final long TILE = 112_000;
    /** Part of Java's heap that tiles may take. */
    private static final int SHARE = 4;
    private static final int MIN_HELD = 64;
    /** Of rows, columns and places: whole parts of a metre, few enough that all sums of them are exact. */
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
    /** Of each tile: twice how many had been made when it was used last, and one less if it was made then. */
    private final AtomicLongArray used;
    private int count;
    private volatile long made;

    /** Where heights come from. Any thread. */
    public interface Source {
        /**
         * The heights of posts, metres, row by row from the south, each from the west; the same each time.
         *
         * @param row the first one, likewise column
         * @param width how many columns, likewise height
         */
        float[] heights(int row, int column, int height, int width);
    }

    /** Sees each tile once. */
    public interface Visitor {
        /**
         * A tile, in the grid's frame.
         *
         * @param row its first row of posts in the grid, likewise column
         */
        void see(HeightField tile, int row, int column);
    }

    /**
     * Looks at all tiles once, row by row from the south, to know their least and greatest heights.
     *
     * @param lowX metres, and likewise lowZ and the spacings: as {@link #exact} makes them
     * @param most tiles that are held at most
     * @param visitor sees each tile
     */
    public HeightTiles(int rows, int columns, double lowX, double lowZ, double spacingX, double spacingZ, Source source, int most, Visitor visitor) {
        super(rows, columns, lowX, lowZ, spacingX, spacingZ);
        if (exact(lowX) != lowX || exact(lowZ) != lowZ || exact(spacingX) != spacingX || exact(spacingZ) != spacingZ || most < 1) {
            throw new IllegalArgumentException("height tiles: from " + lowX + ", " + lowZ + " on, " + spacingX + " and " + spacingZ + " m apart, "
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

    /** The nearest number of metres by which rows and columns of tiles can stand so that neighbours agree to the bit. */
    public static double exact(double metres) {
        return Math.rint(metres * EXACT) / EXACT;
    }

    /** How many tiles may be held: {@link #MAX_HELD}, or what fits into a quarter of Java's heap. */
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

    /** How many tiles there are; they are numbered row by row from the south, each from the west. */
    public int size() {
        return lows.length;
    }

    /** The first row of posts of a tile. */
    public int firstRow(int number) {
        return number / tileColumns * CELLS;
    }

    /** The first column of posts of a tile. */
    public int firstColumn(int number) {
        return number % tileColumns * CELLS;
    }

    /** The last row of posts of a tile. */
    public int lastRow(int number) {
        return Math.min(firstRow(number) + CELLS, rows - 1);
    }

    /** The last column of posts of a tile. */
    public int lastColumn(int number) {
        return Math.min(firstColumn(number) + CELLS, columns - 1);
    }

    /** The least height in a tile, metres. */
    public float low(int number) {
        return lows[number];
    }

    /** The greatest height in a tile, metres. */
    public float high(int number) {
        return highs[number];
    }

    /** A tile, in the grid's frame. */
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

    /** How many tiles have been made since all were looked at: the work done. */
    public long made() {
        return made;
    }

    /** How many tiles are held. */
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
