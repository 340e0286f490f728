package org.SEAR.terrain;

import java.io.IOException;
import org.SEAR.terrain.format.Georeference;
import org.locationtech.proj4j.BasicCoordinateTransform;
import org.locationtech.proj4j.CRSFactory;
import org.locationtech.proj4j.CoordinateReferenceSystem;
import org.locationtech.proj4j.ProjCoordinate;

/** Converts between a map's coordinate system and latitude and longitude of WGS 84. One thread at a time. */
final class MapSystem {
    /** Whether map coordinates are degrees: x east, y north. */
    final boolean degrees;
    private final BasicCoordinateTransform toMap;
    private final BasicCoordinateTransform toEarth;
    private final ProjCoordinate from = new ProjCoordinate();
    private final ProjCoordinate to = new ProjCoordinate();

    /**
     * @param file the map's name for messages
     * @param system EPSG:NUMBER or PROJ parameters
     * @throws IOException for an unknown system
     */
    MapSystem(String file, String system) throws IOException {
        if (system.equals(Georeference.WGS84)) {
            degrees = true;
            toMap = null;
            toEarth = null;
            return;
        }
        try {
            CRSFactory systems = new CRSFactory();
            CoordinateReferenceSystem earth = systems.createFromParameters("WGS84", "+proj=longlat +datum=WGS84 +no_defs");
            CoordinateReferenceSystem map = system.startsWith("+") ? systems.createFromParameters("map", system) : systems.createFromName(system);
            degrees = map.isGeographic();
            toMap = new BasicCoordinateTransform(earth, map);
            toEarth = new BasicCoordinateTransform(map, earth);
        } catch (RuntimeException e) {
            throw new IOException(file + ": the coordinate system is " + system + " (" + e.getMessage()
                + "), legal: an EPSG system of PROJ 4: convert the map, for example by gdalwarp -t_srs EPSG:4326", e);
        }
    }

    /**
     * Converts latitude and longitude to map coordinates.
     * @param into receives x and y; not finite outside the system's range
     */
    void toMap(double latitude, double longitude, double[] into) {
        transform(toMap, longitude, latitude, into);
    }

    /** Converts map coordinates to {latitude, longitude}, degrees; not finite for invalid coordinates. */
    double[] toEarth(double x, double y) {
        double[] place = new double[2];
        transform(toEarth, x, y, place);
        return new double[] {place[1], place[0]};
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
