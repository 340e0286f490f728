// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.Supplier;
import org.SEAR.files.FileLimits;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.terrain.format.MapLimits;

/** Builds the ground of a world from opened maps. One thread. */
final class GroundBuilder {
    private static final double MAX_METRES = 1_000_000;
    private static final double HALF_CELL = 0.5;

    private final Mosaic mosaic;
    private final String file;
    private final TerrainArea wanted;
    private final int atOnce;
    private final List<String> warnings = new ArrayList<>();

    GroundBuilder(Mosaic mosaic, TerrainArea wanted) {
        this(mosaic, wanted, MapLimits.MAX_POSTS);
    }

    /** @param atOnce maximum number of posts in memory; larger grounds are cut into tiles */
    GroundBuilder(Mosaic mosaic, TerrainArea wanted, int atOnce) {
        this.atOnce = atOnce;
        this.mosaic = mosaic;
        this.file = mosaic.first().name;
        this.wanted = wanted;
    }

    /**
     * Builds the ground.
     * @throws IOException that names the map, the error and what is legal
     */
    Ground build() throws IOException {
        Ground ground = mosaic.place.system != null ? onEarth() : flat();
        warnings.addAll(mosaic.cutOff());
        return ground;
    }

    private Ground onEarth() throws IOException {
        TerrainArea.Area area = wanted.area;
        if (wanted.size != null) {
            throw FileLimits.wrong(file, "the size", "given", "no setSize for a georeferenced map: use setArea to "
                + "choose a part");
        }
        double middleX = mosaic.place.x((mosaic.columns - 1) / 2.0, (mosaic.rows - 1) / 2.0);
        double middleY = mosaic.place.y((mosaic.columns - 1) / 2.0, (mosaic.rows - 1) / 2.0);
        MapSystem system = area == null ? MapSystem.over(file, mosaic.place.system, middleX, middleY)
            : MapSystem.at(file, mosaic.place.system, area.latitude, area.longitude);
        double[] middle = system.toEarth(middleX, middleY);
        if (!(Math.abs(middle[0]) <= 90) || !(Math.abs(middle[1]) <= 720)) {
            throw FileLimits.wrong(file, "the centre of the map", "latitude " + middle[0] + ", longitude " + middle[1],
                "a place on Earth (is the coordinate system " + mosaic.place.system + " correct?)");
        }
        double longitude = area == null ? middle[1] - 360 * Math.rint(middle[1] / 360) : area.longitude;
        GeoOrigin level = new GeoOrigin(area == null ? middle[0] : area.latitude, 0, longitude);
        MapPlane plane = MapPlane.onEarth(level, system, mosaic.place, middleX);
        double[] size = area == null ? null : new double[] {area.northSouth, area.eastWest};
        if (size != null && new MapExtent(mosaic, plane).box(size[0], size[1], HALF_CELL) == null) {
            throw MapExtent.beyond(mosaic, system, area);
        }
        Made made = make(plane, size);
        double altitude = made.lower(1);
        return new Ground(made.heights, made.field,
            new GeoOrigin(level.getLatitude(), altitude, level.getLongitude()), altitude,
            made.spacing, new MapHeights(made.map, mosaic.place, system, middleX), warnings);
    }

    private Ground flat() throws IOException {
        if (wanted.area != null) {
            throw FileLimits.wrong(file, "the area", "given",
                "no setArea for a map without a georeference: use setSize");
        }
        TerrainArea.Size size = wanted.size;
        if (size == null && mosaic.first().place == null) {
            throw FileLimits.wrong(file, "the size", "not known", "setSize(northSouth, eastWest, lowest, "
                + "highest) in metres");
        }
        double unitsX = (mosaic.columns - 1) * mosaic.place.columnSpacing();
        double unitsY = (mosaic.rows - 1) * mosaic.place.rowSpacing();
        double[] metres = size == null ? new double[] {unitsY, unitsX} : new double[] {size.northSouth, size.eastWest};
        MapPlane plane = MapPlane.flat(
            mosaic.place, mosaic.place.x((mosaic.columns - 1) / 2.0, (mosaic.rows - 1) / 2.0),
            mosaic.place.y((mosaic.columns - 1) / 2.0, (mosaic.rows - 1) / 2.0), unitsX / metres[1],
                unitsY / metres[0]);
        Made made = make(plane, metres);
        if (size == null) {
            double altitude = made.lower(1);
            return new Ground(made.heights, made.field, null, altitude, made.spacing, null, warnings);
        }
        double[] range = mosaic.first().white > 0 ? new double[] {0, mosaic.first().white} : made.range.get();
        double factor = range[1] > range[0] ? (size.highest - size.lowest) / (range[1] - range[0]) : 0;
        double middle = made.lower(factor);
        return new Ground(made.heights, made.field, null, size.lowest + (middle - range[0]) * factor, made.spacing,
            null, warnings);
    }

    private Made make(MapPlane plane, double[] size) throws IOException {
        double[][] steps = steps(plane);
        double[] metres = steps[0];
        MapExtent extent = new MapExtent(mosaic, plane);
        double[] used = size != null ? size : extent.fitted(Math.min(MAX_METRES, (mosaic.rows - 1) * metres[0]),
            Math.min(MAX_METRES, (mosaic.columns - 1) * metres[1]));
        if (!(used[0] > 0 && used[1] > 0 && used[0] <= MAX_METRES && used[1] <= MAX_METRES)) {
            throw FileLimits.wrong(file, "the size of the area", used[0] + " m x " + used[1] + " m", "more than 0 to "
                + (int) MAX_METRES + " m");
        }
        double[] box = extent.box(used[0], used[1], HALF_CELL);
        if (box == null) {
            throw FileLimits.wrong(file, "the area", used[0] + " m x " + used[1] + " m", "on the map");
        }
        FieldGrid grid = FieldGrid.of(used, metres, steps[1], size != null);
        FieldSampler.require(file, grid);
        int[] part = part(box);
        double spacing = Math.max(metres[0], metres[1]);
        if (grid.posts() > atOnce || (long) part[2] * part[3] > atOnce) {
            FieldGrid exact = grid.exact();
            return new Paged(RasterFile.of(mosaic, part, atOnce / 2, warnings), exact,
                PlaneLattice.of(exact, plane, metres[1], metres[0]), spacing);
        }
        MapRaster raster = mosaic.read(part[0], part[1], part[2], part[3]);
        FieldSampler sampler = new FieldSampler(file, grid, PlaneLattice.of(grid, plane, metres[1], metres[0]), raster);
        sampler.fillGaps(warnings);
        return new Whole(sampler.field(), raster, spacing);
    }

    /**
     * Returns, at the origin, the spacing of the map's posts going north and going east, and the offset of the map's
     * first post north and east, metres.
     */
    private double[][] steps(MapPlane plane) throws IOException {
        double[] zero = new double[2];
        double[] north = new double[2];
        double[] east = new double[2];
        plane.at(0, 0, zero);
        plane.at(1, 0, north);
        plane.at(0, 1, east);
        double x = 1 / Math.hypot(north[0] - zero[0], north[1] - zero[1]);
        double z = 1 / Math.hypot(east[0] - zero[0], east[1] - zero[1]);
        if (!(x > 0) || !(z > 0) || Double.isInfinite(x) || Double.isInfinite(z)) {
            throw FileLimits.wrong(file, "the distance of posts", x + " m x " + z + " m", "above 0");
        }
        return new double[][] {{x, z},
            {-zero[1] * x * Math.signum(north[1] - zero[1]), -zero[0] * z * Math.signum(east[0] - zero[0])}};
    }

    /** Returns first row, first column, rows and columns of the used part of the map. */
    private int[] part(double[] box) throws IOException {
        int left = start(box[0], mosaic.columns);
        int top = start(box[1], mosaic.rows);
        long width = Math.min(mosaic.columns - 1, (long) Math.ceil(box[2]) + 1) - left + 1;
        long height = Math.min(mosaic.rows - 1, (long) Math.ceil(box[3]) + 1) - top + 1;
        FileLimits.range(file, "the number of the map's posts in the area", width * height, 4, MapLimits.MOST_POSTS);
        return new int[] {top, left, (int) height, (int) width};
    }

    private static int start(double low, int count) {
        return (int) Math.max(0, Math.min(count - 2, Math.floor(low) - 1));
    }

    /** Common parts of grounds in memory and in tiles. */
    private abstract static class Made {
        /** Elevation by column and row of the map. */
        final DoubleBinaryOperator map;
        final Supplier<double[]> range;
        final double spacing;
        HeightGrid heights;
        HeightField field;

        Made(DoubleBinaryOperator map, Supplier<double[]> range, double spacing) {
            this.map = map;
            this.range = range;
            this.spacing = spacing;
        }

        /** Sets the elevation at the origin to 0 and returns the previous value. */
        abstract double lower(double factor) throws IOException;
    }

    /** Ground in memory. */
    private static final class Whole extends Made {
        Whole(HeightField field, MapRaster raster, double spacing) {
            super(raster::height, raster::range, spacing);
            this.field = field;
            heights = field;
        }

        @Override
        double lower(double factor) {
            double zero = field.height(0, 0);
            for (int i = 0; i < field.heights.length; i++) {
                field.heights[i] = (float) ((field.heights[i] - zero) * factor);
            }
            return zero;
        }
    }

    /** Ground in tiles. */
    private final class Paged extends Made {
        private final RasterFile raster;
        private final FieldGrid grid;
        private final PlaneLattice lattice;

        Paged(RasterFile raster, FieldGrid grid, PlaneLattice lattice, double spacing) {
            super(raster::height, raster::range, spacing);
            this.raster = raster;
            this.grid = grid;
            this.lattice = lattice;
        }

        @Override
        double lower(double factor) throws IOException {
            double zero = new TileSampler(file, grid, lattice, raster, 0, 1).atOrigin();
            HeightField[] overview = new HeightField[1];
            heights = new TileSampler(file, grid, lattice, raster, zero, factor).tiles(overview);
            field = overview[0];
            return zero;
        }
    }
}
