// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.IOException;
import org.SEAR.terrain.format.Georeference;
import org.locationtech.proj4j.BasicCoordinateTransform;
import org.locationtech.proj4j.CRSFactory;
import org.locationtech.proj4j.CoordinateReferenceSystem;
import org.locationtech.proj4j.ProjCoordinate;

/** Converts between a map's coordinate system and latitude and longitude of WGS 84. One thread at a time. */
final class MapSystem {
    private static final String EARTH = "+proj=longlat +datum=WGS84 +no_defs";

    /** Whether map coordinates are angles: x east, y north. */
    final boolean geographic;
    /** Full turn of longitude in map coordinates, 360 for degrees; 0 for a projected system. */
    private final double turn;
    /** Degrees per unit of a geographic system; otherwise 1. */
    private final double unit;
    private final BasicCoordinateTransform toMap;
    private final BasicCoordinateTransform toEarth;
    private final ProjCoordinate from = new ProjCoordinate();
    private final ProjCoordinate to = new ProjCoordinate();

    /** @param parameters PROJ parameters; null for WGS 84 in degrees */
    private MapSystem(String parameters, double unit) {
        this.unit = unit == 0 ? 1 : unit;
        if (parameters == null) {
            geographic = true;
            toMap = null;
            toEarth = null;
        } else {
            CRSFactory systems = new CRSFactory();
            CoordinateReferenceSystem earth = systems.createFromParameters("WGS84", EARTH);
            CoordinateReferenceSystem map = systems.createFromParameters("map", parameters);
            geographic = map.isGeographic();
            toMap = new BasicCoordinateTransform(earth, map);
            toEarth = new BasicCoordinateTransform(map, earth);
        }
        turn = geographic ? 360 / this.unit : 0;
    }

    /**
     * Returns the conversion with the datum shift for a place on Earth.
     * @param file the map's name for messages
     * @param system EPSG:NUMBER or PROJ parameters
     * @param latitude degrees, likewise longitude
     * @throws IOException for an unsupported system, or for a place without a datum shift
     */
    static MapSystem at(String file, String system, double latitude, double longitude) throws IOException {
        if (system.equals(Georeference.WGS84)) {
            return new MapSystem(null, 1);
        }
        try {
            if (system.startsWith("+")) {
                return new MapSystem(system, 1);
            }
            EpsgSystem definition = EpsgSystem.of(file, system);
            return new MapSystem(definition.at(latitude, longitude), definition.unit);
        } catch (RuntimeException e) {
            throw EpsgSystem.unsupported(file, system + " (" + e.getMessage() + ")",
                "one with a number of the EPSG register");
        }
    }

    /**
     * Returns the conversion with the datum shift for a position on the map.
     * @param file the map's name for messages
     * @param system EPSG:NUMBER or PROJ parameters
     * @param x map coordinate, likewise y
     * @throws IOException for an unsupported system, or for a position without a datum shift
     */
    static MapSystem over(String file, String system, double x, double y) throws IOException {
        if (system.equals(Georeference.WGS84) || system.startsWith("+")) {
            return at(file, system, 0, 0);
        }
        EpsgSystem definition = EpsgSystem.of(file, system);
        try {
            double[] place = new MapSystem(definition.withoutShift(), definition.unit).toEarth(x, y);
            return at(file, system, place[0], place[1]);
        } catch (RuntimeException e) {
            throw EpsgSystem.unsupported(file, system + " (" + e.getMessage() + ")",
                "one with a number of the EPSG register");
        }
    }

    /**
     * Converts latitude and longitude to map coordinates.
     * @param into receives x and y; not finite outside the system's range
     */
    void toMap(double latitude, double longitude, double[] into) {
        transform(toMap, longitude, latitude, into);
        if (geographic) {
            into[0] /= unit;
            into[1] /= unit;
        }
    }

    /** Converts map coordinates to {latitude, longitude}, degrees; not finite for invalid coordinates. */
    double[] toEarth(double x, double y) {
        double[] place = new double[2];
        transform(toEarth, geographic ? x * unit : x, geographic ? y * unit : y, place);
        return new double[] {place[1], place[0]};
    }

    /**
     * Returns x of a geographic system, changed by full turns to be closest to another; of a projected one unchanged.
     */
    double turned(double x, double closeTo) {
        return geographic ? x + turn * Math.rint((closeTo - x) / turn) : x;
    }

    private void transform(BasicCoordinateTransform transform, double x, double y, double[] into) {
        into[0] = x;
        into[1] = y;
        if (transform == null) {
            return;
        }
        from.setValue(x, y);
        try {
            transform.transform(from, to);
            into[0] = to.x;
            into[1] = to.y;
        } catch (RuntimeException e) {
            into[0] = Double.NaN;
        }
    }
}
