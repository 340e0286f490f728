package org.SEAR.POJOs;

import java.io.IOException;

/** Looks into the elevation maps of a terrain. The project room implements it; found by {@link java.util.ServiceLoader}. Any thread. */
public interface GroundHeights {
    /**
     * The ground's height at a place on the Earth, metres above the geoid, as the map has it.
     *
     * @param latitude degrees, north positive
     * @param longitude degrees, east positive
     * @throws IOException if the map can't be read
     * @throws IllegalArgumentException that names the area's extent if the place is outside, or says that the map has no place on Earth
     */
    double height(Terrain terrain, double latitude, double longitude) throws IOException;
}
