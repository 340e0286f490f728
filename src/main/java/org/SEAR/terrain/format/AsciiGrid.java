// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.IOException;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.SEAR.files.FileLimits;
import org.SEAR.terrain.tiff.MapBytes;

/**
 * ESRI ASCII grid: a header of names and values, then the elevations in metres, row by row from the north. The
 * coordinate system comes from a .prj beside it. Without one, coordinates in the range of degrees count as degrees of
 * WGS 84.
 */
final class AsciiGrid extends ElevationMap {
    private static final int MAX_SIDE = 1_000_000;
    /** Maximum size of the header, and of white space, bytes. */
    private static final int MAX_HEAD = 1 << 16;
    /** Maximum size of an elevation and the white space after it, bytes; a double has at most 24 characters. */
    private static final int MAX_BYTES = 32;
    private static final Set<String> NAMES = Set.of("ncols", "nrows", "xllcorner", "yllcorner", "xllcenter",
        "yllcenter", "cellsize", "dx", "dy", "nodata_value");

    private final float[] heights;

    private AsciiGrid(String name, int rows, int columns, Georeference place, float[] heights) {
        super(name, rows, columns, place, Double.NaN);
        this.heights = heights;
    }

    /**
     * Reads a grid.
     * @param system from the .prj, or null
     */
    static AsciiGrid open(MapBytes file, String system) throws IOException {
        MapTokens words = new MapTokens(file);
        Map<String, Double> head = head(file, words);
        int columns = side(file.getName(), head, "ncols");
        int rows = side(file.getName(), head, "nrows");
        Georeference place = place(file.getName(), head, rows);
        double noData = head.getOrDefault("nodata_value", -9999.0);
        float[] heights = new float[rows * columns];
        for (int i = 0; i < heights.length; i++) {
            if (i > 0) {
                words.next();
            }
            double height = words.number(i, columns);
            heights[i] = height == noData || !(Math.abs(height) <= MapLimits.HIGHEST) ? Float.NaN : (float) height;
        }
        file.close();
        return new AsciiGrid(file.getName(), rows, columns, system != null ? place.in(system)
            : guessed(place, rows, columns), heights);
    }

    /**
     * Checks a grid's header and whether the file size fits the number of posts.
     * @throws IOException that describes the error
     */
    static void check(MapBytes file) throws IOException {
        Map<String, Double> head = head(file, new MapTokens(file));
        place(file.getName(), head, side(file.getName(), head, "nrows"));
    }

    private static Map<String, Double> head(MapBytes file, MapTokens words) throws IOException {
        Map<String, Double> head = new HashMap<>();
        while (words.next() && NAMES.contains(words.text().toLowerCase(Locale.ROOT))) {
            String key = words.text().toLowerCase(Locale.ROOT);
            words.next();
            head.put(key, MapTokens.number(file.getName(), key, words.text()));
        }
        long posts = (long) side(file.getName(), head, "ncols") * side(file.getName(), head, "nrows");
        FileLimits.range(file.getName(), "the number of posts", posts, 4, MapLimits.MAX_POSTS);
        requireSize(file, posts);
        return head;
    }

    private static void requireSize(MapBytes file, long posts) throws IOException {
        long most = MAX_HEAD + MAX_BYTES * posts;
        if (file.size() < 2 * posts || file.size() > most) {
            throw FileLimits.wrong(file.getName(), "the file's size", file.size(), 2 * posts + " to " + most + " for "
                + posts + " heights" + (file.size() < most ? " (is it cut off?)" : ""));
        }
    }

    private static Georeference place(String file, Map<String, Double> head, int rows) throws IOException {
        double dx = value(file, head, head.containsKey("dx") ? "dx" : "cellsize");
        double dy = value(file, head, head.containsKey("dy") ? "dy" : "cellsize");
        if (!(dx > 0) || !(dy > 0)) {
            throw FileLimits.wrong(file, "cellsize", Math.min(dx, dy), "above 0");
        }
        double x = head.containsKey("xllcenter") ? value(file, head, "xllcenter")
            : value(file, head, "xllcorner") + dx / 2;
        double y = head.containsKey("yllcenter") ? value(file, head, "yllcenter")
            : value(file, head, "yllcorner") + dy / 2;
        return new Georeference(null, x, y + dy * (rows - 1), dx, 0, 0, -dy);
    }

    private static Georeference guessed(Georeference place, int rows, int columns) {
        boolean degrees = place.xColumn <= 1 && -place.yRow <= 1 && place.x0 >= -181 && place.x(columns - 1, 0) <= 361
            && place.y0 <= 91 && place.y(0, rows - 1) >= -91;
        return degrees ? place.in(Georeference.WGS84) : place;
    }

    private static int side(String file, Map<String, Double> head, String key) throws IOException {
        double value = value(file, head, key);
        if (!(value >= 2 && value <= MAX_SIDE) || value != Math.rint(value)) {
            throw FileLimits.wrong(file, key, value, "2 to " + MAX_SIDE);
        }
        return (int) value;
    }

    private static double value(String file, Map<String, Double> head, String key) throws IOException {
        Double value = head.get(key);
        if (value == null) {
            throw FileLimits.wrong(file, key, "missing", "an ESRI ASCII grid begins with ncols, nrows, xllcorner, "
                + "yllcorner and cellsize");
        }
        return value;
    }

    @Override
    public float[] read(int row, int column, int height, int width) {
        if (row == 0 && column == 0 && height == rows && width == columns) {
            return heights.clone();
        }
        float[] part = new float[height * width];
        for (int r = 0; r < height; r++) {
            System.arraycopy(heights, (row + r) * columns + column, part, r * width, width);
        }
        return part;
    }

    @Override
    public void close() {
        // open() has read and closed the file
    }
}
