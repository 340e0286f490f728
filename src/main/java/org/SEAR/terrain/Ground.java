// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.util.Collections;
import java.util.List;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightGrid;

/** Ground of a world, built from elevation maps. Immutable, any thread. */
public final class Ground {
    /**
     * Elevations relative to the world's origin, the area's centre, where y is 0. Physics and sensors use this grid.
     */
    public final HeightGrid heights;
    /** The same grid, or a coarser one if the ground exceeds the memory, for pictures of the whole ground. */
    public final HeightField field;
    /**
     * Position of the world's origin on Earth, with the ground's altitude there; null for maps without a georeference.
     */
    public final GeoOrigin origin;
    /** Elevation of y = 0 in the map, metres; above the geoid for maps of the Earth. */
    public final double altitude;
    /** Spacing of the map's posts, metres: the resolution of the elevations. The field may be finer. */
    public final double spacing;
    /** Warnings for the user, such as the interpolated share of the area; usually empty. */
    public final List<String> warnings;

    private final MapHeights map;

    Ground(HeightGrid heights, HeightField field, GeoOrigin origin, double altitude, double spacing, MapHeights map,
        List<String> warnings) {
        this.heights = heights;
        this.field = field;
        this.map = map;
        this.origin = origin;
        this.altitude = altitude;
        this.spacing = spacing;
        this.warnings = Collections.unmodifiableList(warnings);
    }

    /**
     * Returns the map's elevation at a position, metres above the geoid; NaN outside the area. The field follows the
     * map within decimetres if it is finer than the map; otherwise it flattens ridges.
     * @param latitude degrees, + north
     * @param longitude degrees, + east
     * @throws IllegalStateException if the maps have no georeference
     */
    public double height(double latitude, double longitude) {
        if (origin == null) {
            throw new IllegalStateException("the terrain's map has no georeference, so positions have no latitude "
                + "and longitude");
        }
        double[] at = origin.to(latitude, longitude);
        return Double.isNaN(heights.height(at[0], at[1])) ? Double.NaN : map.height(latitude, longitude);
    }
}
