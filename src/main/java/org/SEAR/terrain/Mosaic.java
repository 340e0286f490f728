// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.SEAR.files.Assets;
import org.SEAR.files.FileLimits;
import org.SEAR.terrain.format.ElevationMap;
import org.SEAR.terrain.format.ElevationMaps;
import org.SEAR.terrain.format.Georeference;
import org.SEAR.terrain.format.MapLimits;

/**
 * One or several maps combined on the grid of the finest one. Where maps overlap, the first with data wins. Maps on
 * other grids are resampled bilinearly. One thread at a time.
 */
final class Mosaic implements Closeable {
    private static final int MAX_TILES = 100;
    private static final long MAX_SIDE = 100_000_000;

    /** Georeference of the posts. For pictures, map coordinates are columns from the west and rows from the south. */
    final Georeference place;
    final int rows;
    final int columns;
    private final List<ElevationMap> maps;
    /** Georeference of each map, with longitudes wrapped to the first map's. */
    private final List<Georeference> places = new ArrayList<>();

    private Mosaic(List<ElevationMap> maps) throws IOException {
        this.maps = maps;
        ElevationMap first = maps.get(0);
        for (ElevationMap map : maps) {
            if (maps.size() > 1) {
                requireSameSystem(first, map);
            }
            places.add(turned(placeOf(map), placeOf(first)));
        }
        Georeference finest = places.get(0);
        for (Georeference each : places) {
            finest = each.columnSpacing() * each.rowSpacing() < 0.999 * finest.columnSpacing() * finest.rowSpacing()
                ? each : finest;
        }
        double[] bounds = {Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        for (int i = 0; i < maps.size(); i++) {
            boolean aligned = finest.isAligned(places.get(i), maps.get(i).columns - 1, maps.get(i).rows - 1);
            extend(bounds, box(finest, places.get(i), maps.get(i), aligned ? 0 : 0.5), aligned);
        }
        FileLimits.range(first.name, "the mosaic's number of columns", (long) (bounds[2] - bounds[0]) + 1, 2, MAX_SIDE);
        FileLimits.range(first.name, "the mosaic's number of rows", (long) (bounds[3] - bounds[1]) + 1, 2, MAX_SIDE);
        place = finest.from(bounds[0], bounds[1]);
        columns = (int) (bounds[2] - bounds[0]) + 1;
        rows = (int) (bounds[3] - bounds[1]) + 1;
    }

    /**
     * Opens maps.
     * @param paths below the assets, at least one
     * @throws IOException that names the map and the error
     */
    static Mosaic open(Assets assets, List<String> paths) throws IOException {
        FileLimits.range(paths.get(0), "the number of tiles", paths.size(), 1, MAX_TILES);
        List<ElevationMap> maps = new ArrayList<>();
        try {
            for (String path : paths) {
                maps.add(ElevationMaps.open(assets, path));
            }
            return new Mosaic(maps);
        } catch (IOException | RuntimeException e) {
            closeAll(maps);
            throw e;
        }
    }

    /** Returns the first map, for properties that all maps share. */
    ElevationMap first() {
        return maps.get(0);
    }

    /** Returns a warning for each map whose file is truncated. */
    List<String> cutOff() {
        List<String> lines = new ArrayList<>();
        for (ElevationMap map : maps) {
            String missing = map.missing();
            if (missing != null) {
                lines.add(map.name + ": the file is cut off: " + missing + " are beyond its end; the area needs "
                    + "none of them");
            }
        }
        return lines;
    }

    private static Georeference placeOf(ElevationMap map) {
        return map.place != null ? map.place : new Georeference(null, 0, map.rows - 1.0, 1, 0, 0, -1);
    }

    private static void requireSameSystem(ElevationMap first, ElevationMap map) throws IOException {
        if (map.place == null) {
            throw FileLimits.wrong(map.name, "the georeference", "missing", "a georeference for each of several tiles");
        }
        if (first.place != null && !Objects.equals(first.place.system, map.place.system)) {
            throw FileLimits.wrong(map.name, "the coordinate system", map.place.system, first.place.system + " as in "
                + first.name);
        }
    }

    /** Wraps degrees of longitude by full turns towards the first map. */
    private static Georeference turned(Georeference map, Georeference first) {
        return Georeference.WGS84.equals(map.system) ? map.moved(360 * Math.rint((first.x0 - map.x0) / 360), 0) : map;
    }

    private static double[] box(Georeference grid, Georeference map, ElevationMap size, double border) {
        double[] bounds = {Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        for (int corner = 0; corner < 4; corner++) {
            double c = (corner & 1) == 0 ? -border : size.columns - 1 + border;
            double r = (corner & 2) == 0 ? -border : size.rows - 1 + border;
            double column = grid.column(map.x(c, r), map.y(c, r));
            double row = grid.row(map.x(c, r), map.y(c, r));
            bounds[0] = Math.min(bounds[0], column);
            bounds[1] = Math.min(bounds[1], row);
            bounds[2] = Math.max(bounds[2], column);
            bounds[3] = Math.max(bounds[3], row);
        }
        return bounds;
    }

    private static void extend(double[] bounds, double[] box, boolean aligned) {
        for (int i = 0; i < 2; i++) {
            bounds[i] = Math.min(bounds[i], aligned ? Math.rint(box[i]) : Math.ceil(box[i] - 0.01));
            bounds[i + 2] = Math.max(bounds[i + 2], aligned ? Math.rint(box[i + 2]) : Math.floor(box[i + 2] + 0.01));
        }
    }

    /**
     * Reads a part.
     * @param row first row, likewise column; all rows and columns must be in the mosaic
     * @throws IOException that names the map and the error
     */
    MapRaster read(int row, int column, int height, int width) throws IOException {
        FileLimits.range(first().name, "the number of posts in the area", (long) height * width, 4,
            MapLimits.MAX_POSTS);
        if (maps.size() == 1) {
            return new MapRaster(row, column, height, width, first().read(row, column, height, width));
        }
        float[] heights = new float[height * width];
        Arrays.fill(heights, Float.NaN);
        MapRaster raster = new MapRaster(row, column, height, width, heights);
        for (int i = 0; i < maps.size(); i++) {
            ElevationMap map = maps.get(i);
            if (place.isAligned(places.get(i), map.columns - 1, map.rows - 1)) {
                copy(map, places.get(i), raster);
            } else {
                resample(map, places.get(i), raster);
            }
        }
        return raster;
    }

    private void copy(ElevationMap map, Georeference where, MapRaster raster) throws IOException {
        int down = (int) Math.rint(place.row(where.x0, where.y0)) - raster.row;
        int across = (int) Math.rint(place.column(where.x0, where.y0)) - raster.column;
        int top = Math.max(0, down);
        int left = Math.max(0, across);
        int height = Math.min(raster.rows, down + map.rows) - top;
        int width = Math.min(raster.columns, across + map.columns) - left;
        if (height <= 0 || width <= 0) {
            return;
        }
        float[] part = map.read(top - down, left - across, height, width);
        for (int r = 0; r < height; r++) {
            for (int c = 0; c < width; c++) {
                int at = (top + r) * raster.columns + left + c;
                raster.heights[at] = Float.isNaN(raster.heights[at]) ? part[r * width + c] : raster.heights[at];
            }
        }
    }

    private void resample(ElevationMap map, Georeference where, MapRaster raster) throws IOException {
        double[] box = box(place, where, map, 0.5);
        int top = (int) Math.max(raster.row, Math.ceil(box[1]));
        int left = (int) Math.max(raster.column, Math.ceil(box[0]));
        int bottom = (int) Math.min(raster.row + raster.rows - 1, Math.floor(box[3]));
        int right = (int) Math.min(raster.column + raster.columns - 1, Math.floor(box[2]));
        if (top > bottom || left > right) {
            return;
        }
        double[] need = {map.columns, map.rows, 0, 0};
        for (int corner = 0; corner < 4; corner++) {
            double x = place.x((corner & 1) == 0 ? left : right, (corner & 2) == 0 ? top : bottom);
            double y = place.y((corner & 1) == 0 ? left : right, (corner & 2) == 0 ? top : bottom);
            need[0] = Math.max(0, Math.min(need[0], Math.floor(where.column(x, y)) - 1));
            need[1] = Math.max(0, Math.min(need[1], Math.floor(where.row(x, y)) - 1));
            need[2] = Math.min(map.columns, Math.max(need[2], Math.ceil(where.column(x, y)) + 2));
            need[3] = Math.min(map.rows, Math.max(need[3], Math.ceil(where.row(x, y)) + 2));
        }
        int height = (int) (need[3] - need[1]);
        int width = (int) (need[2] - need[0]);
        if (height < 2 || width < 2) {
            return;
        }
        MapRaster part = new MapRaster((int) need[1], (int) need[0], height, width,
            map.read((int) need[1], (int) need[0], height, width));
        for (int r = top; r <= bottom; r++) {
            for (int c = left; c <= right; c++) {
                int at = (r - raster.row) * raster.columns + c - raster.column;
                double column = where.column(place.x(c, r), place.y(c, r));
                double row = where.row(place.x(c, r), place.y(c, r));
                boolean inside = column >= -0.51 && row >= -0.51 && column <= map.columns - 0.49
                    && row <= map.rows - 0.49;
                if (inside && Float.isNaN(raster.heights[at])) {
                    raster.heights[at] = (float) part.height(column, row);
                }
            }
        }
    }

    @Override
    public void close() throws IOException {
        closeAll(maps);
    }

    private static void closeAll(List<ElevationMap> maps) throws IOException {
        for (ElevationMap map : maps) {
            map.close();
        }
    }
}
