// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import org.SEAR.files.FileLimits;
import org.SEAR.geometry.HeightField;
import org.SEAR.terrain.format.MapLimits;

/** Resamples a map to the posts of a height field. One thread. */
final class FieldSampler {
    /** Maximum number of posts in a row that have distinct positions as floats. */
    private static final double DISTINCT = 1 << 23;

    private final String file;
    private final FieldGrid grid;
    private final PlaneLattice lattice;
    private final MapRaster raster;

    FieldSampler(String file, FieldGrid grid, PlaneLattice lattice, MapRaster raster) {
        this.file = file;
        this.grid = grid;
        this.lattice = lattice;
        this.raster = raster;
    }

    /** Throws if a field is too large. */
    static void require(String file, FieldGrid grid) throws IOException {
        FileLimits.range(file, "the number of posts (" + grid.rows + " x " + grid.columns
            + "; a smaller area has fewer)", grid.posts(), 9, MapLimits.MOST_POSTS);
        double least = Math.max(grid.rows * grid.spacingX, grid.columns * grid.spacingZ) / DISTINCT;
        if (!(Math.min(grid.spacingX, grid.spacingZ) >= least)) {
            throw FileLimits.wrong(file, "the distance of posts", Math.min(grid.spacingX, grid.spacingZ) + " m",
                "at least " + least + " m in an area as large as this");
        }
    }

    /**
     * Interpolates posts without data.
     * @param warnings receives the share of the area without data
     * @throws IOException if that share exceeds one half
     */
    void fillGaps(List<String> warnings) throws IOException {
        if (!raster.hasGaps()) {
            return;
        }
        long empty = 0;
        double[] row = new double[2 * grid.columns];
        for (int r = 0; r < grid.rows; r++) {
            lattice.places(r, row);
            for (int c = 0; c < grid.columns; c++) {
                empty += raster.isEmpty(row[2 * c], row[2 * c + 1]) ? 1 : 0;
            }
        }
        requireData(file, empty, grid.posts(), warnings);
        GapFill.fill(raster.heights, raster.rows, raster.columns);
    }

    /**
     * Warns about posts without data.
     * @throws IOException if more than half of the posts have none
     */
    static void requireData(String file, long empty, long posts, List<String> warnings) throws IOException {
        double share = 100.0 * empty / posts;
        if (share > 50) {
            throw FileLimits.wrong(file, "the part of the area without data", percent(share),
                "at most 50 %: choose another area, or add the missing tile");
        }
        if (empty > 0) {
            warnings.add(file + ": " + percent(share) + " of the area has no data: SEAR interpolates it");
        }
    }

    /** Returns the exception for an area outside the map's coordinate system. */
    static IOException beyond(String file) {
        return FileLimits.wrong(file, "the area", "outside the map's coordinate system", "inside");
    }

    private static String percent(double share) {
        return share < 0.1 ? "less than 0.1 %" : String.format(Locale.ROOT, "%.1f %%", share);
    }

    /**
     * Returns the field with the map's elevations.
     * @throws IOException if a part of the field is outside the map's coordinate system
     */
    HeightField field() throws IOException {
        float[] heights = new float[grid.rows * grid.columns];
        double[] row = new double[2 * grid.columns];
        for (int r = 0; r < grid.rows; r++) {
            lattice.places(r, row);
            for (int c = 0; c < grid.columns; c++) {
                heights[r * grid.columns + c] = (float) raster.height(row[2 * c], row[2 * c + 1]);
            }
            if (Float.isNaN(heights[r * grid.columns]) || Float.isNaN(heights[(r + 1) * grid.columns - 1])) {
                throw beyond(file);
            }
        }
        return new HeightField(grid.rows, grid.columns, grid.lowX, grid.lowZ, grid.spacingX, grid.spacingZ, heights);
    }
}
