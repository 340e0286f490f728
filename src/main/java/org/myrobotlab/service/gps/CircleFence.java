// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

/** A circle on the Earth. Immutable, any thread. */
public final class CircleFence implements GeoFence {
    private final GeoPoint centre;
    private final double radius;

    /**
     * @param centre not null
     * @param radius metres, > 0
     * @throws IllegalArgumentException if a value is illegal
     */
    public CircleFence(GeoPoint centre, double radius) {
        if (centre == null) {
            throw new IllegalArgumentException(
                "the centre of a geofence is None, legal: a point of setPoint(latitude, longitude)");
        }
        if (!(radius > 0 && radius < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("radius of a geofence is " + radius
                + ", legal: a number above 0, in metres");
        }
        this.centre = centre;
        this.radius = radius;
    }

    /** Returns the latitude of the centre, degrees. */
    public double getLat() {
        return centre.getLat();
    }

    /** Returns the longitude of the centre, degrees. */
    public double getLon() {
        return centre.getLon();
    }

    /** Returns metres. */
    public double getRadius() {
        return radius;
    }

    @Override
    public boolean contains(GeoPoint place) {
        return centre.distanceTo(place) < radius;
    }
}
