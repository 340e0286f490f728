// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.Test;

/** Distances and areas on the Earth, as scripts of MyRobotLab's Gps use them. */
public class GeoFenceTest {
    /** Metres of a degree along the equator: the WGS84 radius. */
    private static final double EQUATOR_DEGREE = Math.toRadians(6378137);

    private static GeoPoint at(double lat, double lon) {
        return new GeoPoint(lat, lon);
    }

    private static PolygonFence polygon(double... degrees) {
        List<GeoPoint> points = new ArrayList<>();
        for (int i = 0; i < degrees.length; i += 2) {
            points.add(at(degrees[i], degrees[i + 1]));
        }
        return new PolygonFence(points);
    }

    @Test
    public void distancesAreThoseOfTheEllipsoid() {
        assertEquals(EQUATOR_DEGREE, at(0, 10).distanceTo(at(0, 11)), 1e-6);
        assertEquals("across the date line", EQUATOR_DEGREE, at(0, 179.5).distanceTo(at(0, -179.5)), 1e-6);
        assertEquals("a quarter of a meridian", 10001965.729, at(0, 5).distanceTo(at(90, 5)), 1e-3);
        assertEquals("a millimetre", 0.001, at(0, 10).distanceTo(at(0, 10 + 0.001 / EQUATOR_DEGREE)), 1e-6);
        assertEquals(0, at(33.61, -80.865).distanceTo(at(33.61, -80.865)), 0);
    }

    @Test
    public void aCircleHasItsRadiusInEachDirection() {
        CircleFence fence = new CircleFence(at(0, 180), 1000);
        double degrees = 1000 / EQUATOR_DEGREE;
        assertTrue(fence.contains(at(0, -180 + 0.999 * degrees)));
        assertFalse(fence.contains(at(0, -180 + 1.001 * degrees)));
        assertTrue(fence.contains(at(0, 180 - 0.999 * degrees)));
        assertTrue("a degree of latitude is shorter", fence.contains(at(1.001 * degrees, 180)));
        assertFalse(fence.contains(at(1.01 * degrees, 180)));
    }

    @Test
    public void aPolygonContainsWhatItsEdgesEnclose() {
        PolygonFence arrow = polygon(0, 0, 10, 0, 5, 5, 10, 10, 0, 10);
        assertTrue(arrow.contains(at(4, 5)));
        assertFalse("in the notch", arrow.contains(at(6, 5)));
        assertTrue(arrow.contains(at(6, 1)));
        assertTrue(arrow.contains(at(6, 9)));
        assertFalse("south", arrow.contains(at(-1, 5)));
        assertFalse("east", arrow.contains(at(5, 11)));
        assertFalse("on the other side of the Earth", arrow.contains(at(4, -175)));
        assertTrue("north of a corner", polygon(0, 0, 5, 5, 0, 10, 10, 5).contains(at(6, 5)));
        assertFalse("south of a corner", polygon(0, 0, 5, 5, 0, 10, 10, 5).contains(at(4, 5)));
    }

    @Test
    public void aPolygonMaySpanTheDateLine() {
        PolygonFence fiji = polygon(-20, 177, -15, 177, -15, -178, -20, -178);
        assertTrue(fiji.contains(at(-17, 179)));
        assertTrue(fiji.contains(at(-17, -179)));
        assertTrue(fiji.contains(at(-17, 180)));
        assertFalse(fiji.contains(at(-17, 176)));
        assertFalse(fiji.contains(at(-17, -177)));
        assertFalse(fiji.contains(at(-17, 0)));
        assertFalse(fiji.contains(at(-17, -1)));
    }

    @Test
    public void illegalValuesAreNamed() {
        assertEquals("latitude is 91.0, legal: -90.0 to 90.0 degrees", refusal(() -> at(91, 0)));
        assertEquals("longitude is NaN, legal: -180.0 to 180.0 degrees", refusal(() -> at(0, Double.NaN)));
        assertEquals("radius of a geofence is -1.0, legal: a number above 0, in metres",
            refusal(() -> new CircleFence(at(0, 0), -1)));
        assertTrue(refusal(() -> new CircleFence(null, 1)).startsWith("the centre of a geofence is None, legal: "));
        assertEquals("a geofence has 2 corners, legal: 3 or more", refusal(() -> polygon(0, 0, 1, 1)));
        assertEquals("a geofence has 0 corners, legal: 3 or more", refusal(() -> new PolygonFence(null)));
        assertEquals("corner 2 of a geofence is 5, legal: a point of setPoint(latitude, longitude)",
            refusal(() -> new PolygonFence(Arrays.asList(at(0, 0), 5, at(1, 1)))));
    }

    private static String refusal(Runnable call) {
        return assertThrows(IllegalArgumentException.class, call::run).getMessage();
    }
}
