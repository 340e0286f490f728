// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * A polygon with straight edges in latitude and longitude; the last corner is connected to the first. It may span the
 * date line, but no pole. Immutable, any thread.
 */
public final class PolygonFence implements GeoFence {
    private static final int FEWEST = 3;
    private static final double TURN = 360;

    private final List<GeoPoint> points;

    /**
     * @param corners points of the GPS service's setPoint, 3 or more
     * @throws IllegalArgumentException if the corners are too few or no points
     */
    public PolygonFence(List<?> corners) {
        List<GeoPoint> copy = new ArrayList<>();
        for (Object corner : corners == null ? Collections.emptyList() : corners) {
            if (!(corner instanceof GeoPoint)) {
                throw new IllegalArgumentException("corner " + (copy.size() + 1) + " of a geofence is " + corner
                    + ", legal: a point of setPoint(latitude, longitude)");
            }
            copy.add((GeoPoint) corner);
        }
        if (copy.size() < FEWEST) {
            throw new IllegalArgumentException("a geofence has " + copy.size() + " corners, legal: " + FEWEST
                + " or more");
        }
        points = Collections.unmodifiableList(copy);
    }

    /** Returns the corners. */
    public List<GeoPoint> getPoints() {
        return points;
    }

    /** Counts the edges that a line from the place to the north crosses. */
    @Override
    public boolean contains(GeoPoint place) {
        boolean inside = false;
        GeoPoint from = points.get(points.size() - 1);
        for (GeoPoint to : points) {
            double west = east(place, from);
            double east = east(place, to);
            if (west > 0 != east > 0 && Math.abs(west - east) < TURN / 2) {
                double crossing = from.getLat() + (to.getLat() - from.getLat()) * west / (west - east);
                inside ^= crossing > place.getLat();
            }
            from = to;
        }
        return inside;
    }

    /** Returns degrees from the place's meridian to a point, + east, [-180, 180]. */
    private static double east(GeoPoint place, GeoPoint point) {
        return Math.IEEEremainder(point.getLon() - place.getLon(), TURN);
    }
}
