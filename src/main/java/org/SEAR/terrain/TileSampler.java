// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightTiles;

/** Resamples a map that exceeds the memory to the posts of one tile at a time. Any thread. */
final class TileSampler implements HeightTiles.Source {
    /** Maximum number of posts of the coarse field of the whole ground. */
    private static final int OVERVIEW = 2_000_000;

    private final String file;
    private final FieldGrid grid;
    private final PlaneLattice lattice;
    private final RasterFile raster;
    private final double zero;
    private final double factor;

    /**
     * @param zero elevation of y = 0 on the map
     * @param factor metres per unit of the map
     */
    TileSampler(String file, FieldGrid grid, PlaneLattice lattice, RasterFile raster, double zero, double factor) {
        this.file = file;
        this.grid = grid;
        this.lattice = lattice;
        this.raster = raster;
        this.zero = zero;
        this.factor = factor;
    }

    @Override
    public float[] heights(int row, int column, int height, int width) {
        double[] places = new double[2 * width];
        double[] box = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY};
        for (int r = 0; r < height; r++) {
            lattice.places(row + r, column, column + width - 1, places);
            for (int i = 0; i < places.length; i++) {
                box[i & 1] = Math.min(box[i & 1], places[i]);
                box[2 + (i & 1)] = Math.max(box[2 + (i & 1)], places[i]);
            }
        }
        if (Double.isNaN(box[0] + box[1])) {
            throw new UncheckedIOException(FieldSampler.beyond(file));
        }
        MapRaster part = raster.around(box);
        float[] heights = new float[height * width];
        for (int r = 0; r < height; r++) {
            lattice.places(row + r, column, column + width - 1, places);
            for (int c = 0; c < width; c++) {
                float one = (float) part.height(raster, places[2 * c], places[2 * c + 1]);
                heights[r * width + c] = (float) ((one - zero) * factor);
            }
        }
        return heights;
    }

    /** Returns the map's elevation at the world's origin, interpolated by the field's triangles. */
    double atOrigin() {
        int row = Math.max(0, Math.min(grid.rows - 3, (int) (-grid.lowX / grid.spacingX) - 1));
        int column = Math.max(0, Math.min(grid.columns - 3, (int) (-grid.lowZ / grid.spacingZ) - 1));
        int height = Math.min(4, grid.rows - row);
        int width = Math.min(4, grid.columns - column);
        return new HeightField(height, width, grid.x(row), grid.z(column), grid.spacingX, grid.spacingZ,
            heights(row, column, height, width)).height(0, 0);
    }

    /**
     * Creates the tiles and a coarse field of the whole ground.
     * @param ground receives the coarse field
     * @throws IOException if a part of the area is outside the map's coordinate system
     */
    HeightTiles tiles(HeightField[] ground) throws IOException {
        int step = 1;
        while (((grid.rows - 2L) / step + 2) * ((grid.columns - 2L) / step + 2) > OVERVIEW) {
            step *= 2;
        }
        int rows = (grid.rows - 2) / step + 2;
        int columns = (grid.columns - 2) / step + 2;
        float[] coarse = new float[rows * columns];
        try {
            HeightTiles tiles = new HeightTiles(grid.rows, grid.columns, grid.lowX, grid.lowZ, grid.spacingX,
                grid.spacingZ, this,
                HeightTiles.room(), (tile, row, column) -> look(tile, row, column, rows, columns, coarse));
            ground[0] = new HeightField(rows, columns, grid.lowX, grid.lowZ,
                (grid.rows - 1) * grid.spacingX / (rows - 1),
                (grid.columns - 1) * grid.spacingZ / (columns - 1), coarse);
            return tiles;
        } catch (UncheckedIOException e) {
            throw new IOException(e.getCause().getMessage(), e);
        }
    }

    /** Copies the elevations of a tile to the coarse posts inside it. */
    private void look(HeightField tile, int row, int column, int rows, int columns, float[] coarse) {
        for (int i = first(row, grid.rows, rows); i < rows && (long) i * (grid.rows - 1) <= (row + tile.rows - 1L) * (
            rows - 1); i++) {
            double x = within(grid.lowX + (grid.rows - 1.0) * i / (rows - 1) * grid.spacingX, tile.x(0),
                tile.x(tile.rows - 1));
            for (int j = first(column, grid.columns, columns);
                    j < columns && (long) j * (grid.columns - 1) <= (column + tile.columns - 1L) * (columns - 1); j++) {
                double z = within(grid.lowZ + (grid.columns - 1.0) * j / (columns - 1) * grid.spacingZ, tile.z(0),
                    tile.z(tile.columns - 1));
                coarse[i * columns + j] = (float) tile.height(x, z);
            }
        }
    }

    /** Returns the first coarse post at or after a post. */
    private static int first(int post, int posts, int coarse) {
        return (int) (((long) post * (coarse - 1) + posts - 2) / (posts - 1));
    }

    private static double within(double value, float low, float high) {
        return Math.max(low, Math.min(high, value));
    }
}
