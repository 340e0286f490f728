// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.io.IOException;

/**
 * Elevation queries on the maps of a terrain. {@link java.util.ServiceLoader} finds the implementation, in
 * {@code org.SEAR.project}. Any thread.
 */
public interface GroundHeights {
    /**
     * Returns the elevation at a geographic position, metres above the geoid.
     *
     * @param latitude degrees, north positive
     * @param longitude degrees, east positive
     * @throws IOException if the map can't be read
     * @throws IllegalArgumentException with the area's extent if the position is outside, or if the map has no
     *     georeference
     */
    double height(Terrain terrain, double latitude, double longitude) throws IOException;
}
