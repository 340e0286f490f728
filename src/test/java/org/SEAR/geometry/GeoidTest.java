// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** The geoid table compared with values of the full model and of real receivers. */
public class GeoidTest {
    /** Latitude, longitude and separation in metres of NGA's test points and Mount Everest. */
    private static final double[][] PUBLISHED = {{38.6281550, 269.7791550, -31.628}, {-14.6212170, 305.0211140, -2.969},
        {46.8743190, 102.4487290, -43.575}, {-23.6174460, 133.8747120, 15.871}, {38.6254730, 359.9995000, 50.066},
        {-0.4667440, 0.0023000, 17.329},
        {27.988056, 86.925278, -28.744}};

    @Test
    public void publishedValuesOfTheWholeModel() {
        for (double[] place : PUBLISHED) {
            assertEquals(place[0] + ", " + place[1], place[2], Geoid.separation(place[0], place[1]), 1);
        }
    }

    /** The GGA example of u-blox has 48.0 m. */
    @Test
    public void realReceiversAgree() {
        assertEquals(48, Geoid.separation(47 + 17.11399 / 60, 8 + 33.91590 / 60), 0.3);
    }

    @Test
    public void theEarthIsRoundEverywhere() {
        assertEquals(13.61, Geoid.separation(90, 0), 1e-9);
        assertEquals(13.61, Geoid.separation(90, 123.4), 1e-9);
        assertEquals(-29.53, Geoid.separation(-90, -77), 0.1);
        assertEquals(Geoid.separation(10, -179.999999), Geoid.separation(10, 179.999999), 1e-4);
        assertEquals(Geoid.separation(10, -0.000001), Geoid.separation(10, 0.000001), 1e-4);
        assertEquals(Geoid.separation(10, -80.7), Geoid.separation(10, 279.3), 1e-9);
        assertEquals(Geoid.separation(10, 0), Geoid.separation(10, -1e-20), 1e-9);
    }
}
