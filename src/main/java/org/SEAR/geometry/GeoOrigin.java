// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import java.util.Locale;
import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import net.sf.geographiclib.GeodesicMask;

/**
 * Position of the world's origin on the Earth. A point (x north, y up, z east) of the world is the end of the WGS84
 * geodesic of length hypot(x, z) that leaves the origin with azimuth atan2(z, x). Near the origin this is x and z
 * divided by the lengths of a degree at its latitude. There are no singularities at equator, poles or date line.
 * Immutable, any thread.
 */
public final class GeoOrigin {
    private static final int WANTED = GeodesicMask.LATITUDE | GeodesicMask.LONGITUDE | GeodesicMask.AZIMUTH;

    private final double latitude;
    private final double altitude;
    private final double longitude;

    /**
     * @param latitude degrees, + north
     * @param altitude metres
     * @param longitude degrees, + east
     */
    public GeoOrigin(double latitude, double altitude, double longitude) {
        this.latitude = latitude;
        this.altitude = altitude;
        this.longitude = longitude;
    }

    /** Returns the place of a point of the world, metres. */
    public GeoPoint at(double x, double y, double z) {
        double azimuth = Math.toDegrees(Math.atan2(z, x));
        GeodesicData end = Geodesic.WGS84.Direct(latitude, longitude, azimuth, Math.hypot(x, z), WANTED);
        return new GeoPoint(end.lat2, end.lon2 >= 180 ? end.lon2 - 360 : end.lon2, altitude + y, end.azi2 - azimuth);
    }

    /**
     * Returns the point of the world's level plane at a place on the Earth: {x north, z east}, metres. Inverse of
     * {@link #at}.
     * @param placeLatitude degrees, + north
     * @param placeLongitude degrees, + east
     */
    public double[] to(double placeLatitude, double placeLongitude) {
        GeodesicData way = Geodesic.WGS84.Inverse(latitude, longitude, placeLatitude, placeLongitude,
            GeodesicMask.DISTANCE | GeodesicMask.AZIMUTH);
        double azimuth = Math.toRadians(way.azi1);
        return new double[] {way.s12 * Math.cos(azimuth), way.s12 * Math.sin(azimuth)};
    }

    /** Degrees, + north. */
    public double getLatitude() {
        return latitude;
    }

    /** Metres. */
    public double getAltitude() {
        return altitude;
    }

    /** Degrees, + east. */
    public double getLongitude() {
        return longitude;
    }

    /** {@code latitude 36.4850000, longitude -84.2308333, altitude 1076.0 m}. */
    @Override
    public String toString() {
        return String.format(Locale.ROOT, "latitude %.7f, longitude %.7f, altitude %.1f m", latitude,
            longitude, altitude);
    }

    /** Place on the Earth. Immutable. */
    public static final class GeoPoint {
        /** Degrees, + north. */
        public final double latitude;
        /** Degrees, + east, [-180, 180). */
        public final double longitude;
        /** Metres. */
        public final double altitude;
        /**
         * Convergence: angle of true north here counter-clockwise from the world's +x axis, degrees; add it to an angle
         * from +x to get one from north.
         */
        public final double convergence;

        GeoPoint(double latitude, double longitude, double altitude, double convergence) {
            this.latitude = latitude;
            this.longitude = longitude;
            this.altitude = altitude;
            this.convergence = convergence;
        }
    }
}
