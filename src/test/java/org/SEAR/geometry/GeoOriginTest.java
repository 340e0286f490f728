// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** Conversion between points of the world and places on Earth, both ways. */
public class GeoOriginTest {
    @Test
    public void placesAndPointsConvertBothWays() {
        double[][] origins = {{36.485, -84.2308}, {0, 0}, {-89.99, 12}, {52, 179.999}};
        for (double[] at : origins) {
            GeoOrigin origin = new GeoOrigin(at[0], 300, at[1]);
            for (double[] point : new double[][] {{0, 0}, {1000, 0}, {-250, 4000}, {-9000, -7000}}) {
                GeoOrigin.GeoPoint place = origin.at(point[0], 5, point[1]);
                double[] back = origin.to(place.latitude, place.longitude);
                assertEquals(point[0], back[0], 1e-6);
                assertEquals(point[1], back[1], 1e-6);
                assertEquals(305, place.altitude, 0);
            }
        }
    }
}
