// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.IOException;
import java.util.Locale;
import java.util.function.DoublePredicate;
import org.SEAR.files.FileLimits;

/** Tests whether a rectangle of the world is on the map, and finds the largest one. One thread at a time. */
final class MapExtent {
    private static final int POINTS = 32;
    private static final int HALVINGS = 30;
    /** Tolerance for rounding, columns and rows. */
    private static final double ROUNDING = 1e-4;

    private final Mosaic mosaic;
    private final MapPlane plane;
    private final double[] at = new double[2];

    MapExtent(Mosaic mosaic, MapPlane plane) {
        this.mosaic = mosaic;
        this.plane = plane;
    }

    /**
     * Returns the part of the map under a rectangle centred at the world's origin: first column, first row, last
     * column, last row. Returns null if the rectangle extends beyond the map.
     * @param border extent of the map beyond the outermost posts, cells
     */
    double[] box(double northSouth, double eastWest, double border) {
        double[] box = {Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        for (int i = 0; i <= 4 * POINTS; i++) {
            double along = (i % POINTS) / (double) POINTS - 0.5;
            boolean northOrSouth = i / POINTS % 2 == 0;
            double side = i / POINTS < 2 ? 0.5 : -0.5;
            plane.at(northSouth * (northOrSouth ? side : along), eastWest * (northOrSouth ? along : side), at);
            box[0] = Math.min(box[0], at[0]);
            box[1] = Math.min(box[1], at[1]);
            box[2] = Math.max(box[2], at[0]);
            box[3] = Math.max(box[3], at[1]);
            if (!(at[0] >= -border - ROUNDING && at[1] >= -border - ROUNDING && at[0] <= mosaic.columns - 1
                + border + ROUNDING && at[1] <= mosaic.rows - 1 + border + ROUNDING)) {
                return null;
            }
        }
        return box;
    }

    /**
     * Returns the largest rectangle inside the map's outermost posts: {metres north-south, metres east-west}.
     * @param northSouth upper bound, metres, likewise eastWest
     */
    double[] fitted(double northSouth, double eastWest) {
        double both = largest(part -> box(northSouth * part, eastWest * part, 0) != null);
        double north = largest(part -> box(northSouth * (both + (1 - both) * part), eastWest * both, 0) != null);
        double down = northSouth * (both + (1 - both) * north);
        double east = largest(part -> box(down, eastWest * (both + (1 - both) * part), 0) != null);
        return new double[] {down, eastWest * (both + (1 - both) * east)};
    }

    private static double largest(DoublePredicate fits) {
        if (fits.test(1)) {
            return 1;
        }
        double low = 0;
        double high = 1;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (low + high) / 2;
            if (fits.test(middle)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Returns the exception for an area that extends beyond the map, with the map's extent. */
    static IOException beyond(Mosaic mosaic, MapSystem system, TerrainArea.Area area) {
        double[] bounds = {Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        for (int i = 0; i < 4; i++) {
            double column = (i & 1) == 0 ? -0.5 : mosaic.columns - 0.5;
            double row = (i & 2) == 0 ? -0.5 : mosaic.rows - 0.5;
            double[] place = system.toEarth(mosaic.place.x(column, row), mosaic.place.y(column, row));
            for (int axis = 0; axis < 2; axis++) {
                bounds[axis] = Math.min(bounds[axis], place[axis]);
                bounds[axis + 2] = Math.max(bounds[axis + 2], place[axis]);
            }
        }
        return FileLimits.wrong(mosaic.first().name, "the area",
            String.format(Locale.ROOT, "%s, %s, %s m x %s m, which reaches beyond the map",
            number(area.latitude), number(area.longitude), number(area.northSouth), number(area.eastWest)),
            String.format(Locale.ROOT, "inside latitudes %.5f to %.5f and longitudes %.5f to %.5f", bounds[0],
                bounds[2], bounds[1], bounds[3]));
    }

    private static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9 ? Long.toString((long) value)
            : Double.toString(value);
    }
}
