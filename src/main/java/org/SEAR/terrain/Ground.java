package org.SEAR.terrain;

import java.util.Collections;
import java.util.List;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightGrid;

/** The ground of a world, made of elevation maps. Immutable, any thread. */
public final class Ground {
    /** Heights about the world's origin, which is the area's centre: there y is 0. Everything drives, stands and looks on these. */
    public final HeightGrid heights;
    /** The same; of a ground that is too large for the memory a coarser one, for pictures of all of it. */
    public final HeightField field;
    /** Where on Earth the world's origin lies, with the altitude of the ground there; null: the maps have no place on Earth. */
    public final GeoOrigin origin;
    /** What y = 0 is in the map, metres, for maps of the Earth above the geoid. */
    public final double altitude;
    /** Metres from post to post of the map, of which the field may have several between: below it the heights tell nothing. */
    public final double spacing;
    /** What the user should know, such as how much was filled in; mostly empty. */
    public final List<String> warnings;

    private final MapHeights map;

    Ground(HeightGrid heights, HeightField field, GeoOrigin origin, double altitude, double spacing, MapHeights map, List<String> warnings) {
        this.heights = heights;
        this.field = field;
        this.map = map;
        this.origin = origin;
        this.altitude = altitude;
        this.spacing = spacing;
        this.warnings = Collections.unmodifiableList(warnings);
    }

    /**
     * The height at a place as the map has it, metres above the geoid; NaN beside the area. The field, on which things stand, follows the map within
     * decimetres where it is finer than the map, and cuts the tops of ridges otherwise.
     *
     * @param latitude degrees, + north
     * @param longitude degrees, + east
     * @throws IllegalStateException if the maps have no place on Earth
     */
    public double height(double latitude, double longitude) {
        if (origin == null) {
            throw new IllegalStateException("the terrain's map has no place on Earth, so that nothing has a latitude and longitude");
        }
        double[] at = origin.to(latitude, longitude);
        return Double.isNaN(heights.height(at[0], at[1])) ? Double.NaN : map.height(latitude, longitude);
    }
}
