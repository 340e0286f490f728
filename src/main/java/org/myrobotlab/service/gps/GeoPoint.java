// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import org.SEAR.geometry.GeoOrigin;

/** A place on the Earth. Immutable, any thread. */
public final class GeoPoint {
    private static final double POLE = 90;
    private static final double DATE_LINE = 180;

    private final double lat;
    private final double lon;

    /**
     * @param lat degrees, + north, [-90, 90]
     * @param lon degrees, + east, [-180, 180]
     * @throws IllegalArgumentException outside these ranges
     */
    public GeoPoint(double lat, double lon) {
        this.lat = checked("latitude", lat, POLE);
        this.lon = checked("longitude", lon, DATE_LINE);
    }

    private static double checked(String what, double degrees, double most) {
        if (!(Math.abs(degrees) <= most)) {
            throw new IllegalArgumentException(what + " is " + degrees + ", legal: " + -most + " to " + most
                + " degrees");
        }
        return degrees;
    }

    /** Returns degrees, + north. */
    public double getLat() {
        return lat;
    }

    /** Returns degrees, + east. */
    public double getLon() {
        return lon;
    }

    /** Returns the length of the geodesic on the WGS84 ellipsoid, metres. */
    public double distanceTo(GeoPoint other) {
        double[] way = new GeoOrigin(lat, 0, lon).to(other.lat, other.lon);
        return Math.hypot(way[0], way[1]);
    }

    @Override
    public String toString() {
        return lat + ", " + lon;
    }
}
