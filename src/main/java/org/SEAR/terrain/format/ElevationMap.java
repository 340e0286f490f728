// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.Closeable;
import java.io.IOException;

/**
 * Raster of elevations in a file, with its georeference if the file has one. Opening reads the header; {@link #read}
 * reads a part. One thread at a time.
 */
public abstract class ElevationMap implements Closeable {
    /** Path of the file, as written in the object. */
    public final String name;
    /** Number of rows; in most maps the first is the northernmost. */
    public final int rows;
    /** Number of columns; in most maps the first is the westernmost. */
    public final int columns;
    /** Georeference of the posts, or null. */
    public final Georeference place;
    /** For pictures: the value of white, with black as 0; NaN for files that contain elevations. */
    public final double white;

    ElevationMap(String name, int rows, int columns, Georeference place, double white) {
        this.name = name;
        this.rows = rows;
        this.columns = columns;
        this.place = place;
        this.white = white;
    }

    /**
     * Reads elevations in metres, row by row; NaN where the map has no data.
     * @param row first row, likewise column
     * @param height number of rows, all inside the map
     * @param width number of columns, all inside the map
     * @throws IOException that names the file and the error
     */
    public abstract float[] read(int row, int column, int height, int width) throws IOException;

    /**
     * Returns what is missing after the end of the file, such as "3 of its 40 strips or tiles". Returns null for a
     * complete file or a format that is read as a whole.
     */
    public String missing() {
        return null;
    }

    @Override
    public abstract void close() throws IOException;
}
