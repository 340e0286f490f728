// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.util.function.DoubleBinaryOperator;
import org.SEAR.terrain.format.Georeference;

/** The map's elevation at any position on Earth. Any thread. */
final class MapHeights {
    private final DoubleBinaryOperator raster;
    private final Georeference place;
    private final MapSystem system;
    private final double middle;

    /** @param raster returns the elevation at a column and row of the map */
    MapHeights(DoubleBinaryOperator raster, Georeference place, MapSystem system, double middle) {
        this.raster = raster;
        this.place = place;
        this.system = system;
        this.middle = middle;
    }

    /** Returns the map's elevation, metres, bilinear between its posts. */
    synchronized double height(double latitude, double longitude) {
        double[] map = new double[2];
        system.toMap(latitude, longitude, map);
        map[0] = system.turned(map[0], middle);
        return raster.applyAsDouble(place.column(map[0], map[1]), place.row(map[0], map[1]));
    }
}
