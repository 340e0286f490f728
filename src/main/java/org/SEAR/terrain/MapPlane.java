// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import org.SEAR.geometry.GeoOrigin;
import org.SEAR.terrain.format.Georeference;

/**
 * Maps the world's horizontal plane, metres north (x) and east (z), to columns and rows of a map. One thread at a time.
 */
abstract class MapPlane {
    private final Georeference place;
    private final double[] map = new double[2];

    MapPlane(Georeference place) {
        this.place = place;
    }

    /** Returns the exact mapping for a world with an origin on Earth. */
    static MapPlane onEarth(GeoOrigin origin, MapSystem system, Georeference place, double middle) {
        return new MapPlane(place) {
            @Override
            void toMap(double x, double z, double[] into) {
                GeoOrigin.GeoPoint point = origin.at(x, 0, z);
                system.toMap(point.latitude, point.longitude, into);
                into[0] = system.turned(into[0], middle);
            }
        };
    }

    /** Returns the mapping for a map without a georeference: its x is east, its y north, scaled in units per metre. */
    static MapPlane flat(Georeference place, double middleX, double middleY, double unitsEast, double unitsNorth) {
        return new MapPlane(place) {
            @Override
            void toMap(double x, double z, double[] into) {
                into[0] = middleX + unitsEast * z;
                into[1] = middleY + unitsNorth * x;
            }
        };
    }

    /** Writes the map coordinates of a point. */
    abstract void toMap(double x, double z, double[] into);

    /**
     * Writes the column and row of a point of the world.
     * @param into receives both, with fractions
     */
    final void at(double x, double z, double[] into) {
        toMap(x, z, map);
        into[0] = place.column(map[0], map[1]);
        into[1] = place.row(map[0], map[1]);
    }
}
