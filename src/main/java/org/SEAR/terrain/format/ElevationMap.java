package org.SEAR.terrain.format;

import java.io.Closeable;
import java.io.IOException;

/**
 * A raster of heights in a file, with its place on Earth if the file says it. Opening it reads its head, {@link #read} the posts that are asked for.
 * One thread at a time.
 */
public abstract class ElevationMap implements Closeable {
    /** The file, as written in the object. */
    public final String name;
    /** From the first, in most maps the northernmost, to the last. */
    public final int rows;
    /** From the first, in most maps the westernmost, to the last. */
    public final int columns;
    /** Where the posts lie; null: the file doesn't say it. */
    public final Georeference place;
    /** For pictures: the value of white, black being 0; NaN for files whose values are heights. */
    public final double white;

    ElevationMap(String name, int rows, int columns, Georeference place, double white) {
        this.name = name;
        this.rows = rows;
        this.columns = columns;
        this.place = place;
        this.white = white;
    }

    /**
     * Reads heights in metres, row by row; NaN where the map has none.
     *
     * @param row the first one, likewise column
     * @param height how many rows, all of them in the map
     * @param width how many columns, all of them in the map
     * @throws IOException that names the file and what is wrong in it
     */
    public abstract float[] read(int row, int column, int height, int width) throws IOException;

    /** What lies beyond the end of the file, such as "3 of its 40 strips or tiles"; null if it is whole, or its kind is only read whole. */
    public String missing() {
        return null;
    }

    /** Ends reading; reading what was read before goes on. */
    @Override
    public abstract void close() throws IOException;
}
