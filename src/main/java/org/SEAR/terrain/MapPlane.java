package org.SEAR.terrain;

import org.SEAR.geometry.GeoOrigin;
import org.SEAR.terrain.format.Georeference;

/** The world's level plane on a map: from metres north (x) and east (z) to columns and rows. One thread at a time. */
abstract class MapPlane {
    private final Georeference place;
    private final double[] map = new double[2];

    MapPlane(Georeference place) {
        this.place = place;
    }

    /** The plane of a world that has its origin on Earth; exact. */
    static MapPlane onEarth(GeoOrigin origin, MapSystem system, Georeference place, double middle) {
        return new MapPlane(place) {
            @Override
            void toMap(double x, double z, double[] into) {
                GeoOrigin.GeoPoint point = origin.at(x, 0, z);
                system.toMap(point.latitude, point.longitude, into);
                if (system.degrees) {
                    into[0] += 360 * Math.rint((middle - into[0]) / 360);
                }
            }
        };
    }

    /** The plane of a map without a place on Earth: its x is east, its y north, with so many units a metre. */
    static MapPlane flat(Georeference place, double middleX, double middleY, double unitsEast, double unitsNorth) {
        return new MapPlane(place) {
            @Override
            void toMap(double x, double z, double[] into) {
                into[0] = middleX + unitsEast * z;
                into[1] = middleY + unitsNorth * x;
            }
        };
    }

    /** The map coordinates of a point. */
    abstract void toMap(double x, double z, double[] into);

    /**
     * The column and row at a point of the world.
     *
     * @param into takes them, with fractions
     */
    final void at(double x, double z, double[] into) {
        toMap(x, z, map);
        into[0] = place.column(map[0], map[1]);
        into[1] = place.row(map[0], map[1]);
    }
}
