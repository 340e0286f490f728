// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.Random;
import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Noise;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** GPS compared with geodesics of the WGS84 ellipsoid and with published lengths of a degree. */
public class GpsSensorTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static final double FIVE_CENTIMETRES = 0.05;

    private static GpsFix at(double latitude, double longitude, double x, double y, double z) {
        return new GpsSensor(new GPS("gps", latitude, 182.5, longitude), 1)
            .read(new ScriptedTruth().at(x, y, z, 0, 0, 0));
    }

    @Test
    public void aKilometreIsWhereTheGeodesicEnds() {
        long seed = 20260101;
        Random random = new Random(seed);
        for (int i = 0; i < 1000; i++) {
            double latitude = random.nextDouble() * 160 - 80;
            double longitude = random.nextDouble() * 360 - 180;
            double azimuth = random.nextDouble() * 360;
            double far = random.nextDouble() * 1000;
            GpsFix fix = at(latitude, longitude, far * Math.cos(Math.toRadians(azimuth)), 0,
                far * Math.sin(Math.toRadians(azimuth)));
            GeodesicData end = Geodesic.WGS84.Direct(latitude, longitude, azimuth, far);
            double miss = Geodesic.WGS84.Inverse(end.lat2, end.lon2, fix.getLatitude(), fix.getLongitude()).s12;
            assertTrue("seed " + seed + ", world " + i + ": " + miss + " m off", miss < FIVE_CENTIMETRES);
        }
    }

    @Test
    public void nearTheOriginMetresAreTheLengthsOfADegree() {
        double[][] table = {{0, 110574.276, 111319.491}, {15, 110648.696, 107550.489}, {30, 110852.442, 96486.280},
            {45, 111131.777, 78846.835},
            {60, 111412.287, 55800.002}, {75, 111618.384, 28902.006}};
        for (double[] row : table) {
            assertEquals(row[0] + 10 / row[1], at(row[0], 0, 10, 0, 0).getLatitude(), 1e-9);
            assertEquals(10 / row[2], at(row[0], 0, 0, 0, 10).getLongitude(), 1e-9);
        }
    }

    @Test
    public void theDissertationsPlaceIsTheOrigin() {
        GpsFix fix = at(33.61, -80.865, 0, 0, 0);
        assertEquals(33.61, fix.getLatitude(), 1e-12);
        assertEquals(-80.865, fix.getLongitude(), 1e-12);
        assertEquals(182.5, fix.getAltitude(), 0);
        assertEquals(185.0, at(33.61, -80.865, 0, 2.5, 0).getAltitude(), 1e-12);
        assertEquals(0, fix.getSpeed(), 0);
        assertEquals(0, fix.getCourse(), 0);
        assertTrue(fix.isValid());
    }

    @Test
    public void theDateLineIsCrossed() {
        assertEquals(-180 + 50 / 111319.491, at(0, 180 - 50 / 111319.491, 0, 0, 100).getLongitude(), 1e-9);
        assertEquals(180 - 50 / 111319.491, at(0, -180 + 50 / 111319.491, 0, 0, -100).getLongitude(), 1e-9);
        assertEquals(-180, at(10, 180, 0, 0, 0).getLongitude(), 0);
    }

    @Test
    public void thePolesAreNotSingular() {
        GpsFix beyond = at(89.9999, 0, 100, 0, 0);
        assertEquals(180, Math.abs(beyond.getLongitude()), 1e-6);
        assertEquals(90 - (100 - 0.0001 * 111693.98) / 111693.98, beyond.getLatitude(), 1e-7);
        GpsFix fromThePole = at(-90, 0, 0, 0, 1000);
        assertEquals(-90 + 1000 / 111693.98, fromThePole.getLatitude(), 1e-7);
        assertEquals(90, fromThePole.getLongitude(), 1e-7);
    }

    @Test
    public void theTimeIsTheSimulations() {
        GpsSensor sensor = new GpsSensor(new GPS("gps", 0, 0, 0), 1);
        ScriptedTruth truth = new ScriptedTruth();
        for (int i = 0; i < 90; i++) {
            truth.advance(sensor);
        }
        assertEquals(ScriptedTruth.NEW_YEAR_2026 + 1500, sensor.read(truth).getTime());
    }

    @Test
    public void speedAndCourseAreTheAntennas() {
        GpsFix fix = new GpsSensor(new GPS("gps", 45, 0, 0), 1).read(new ScriptedTruth().moving(-3, 7, -4));
        assertEquals(5, fix.getSpeed(), 1e-12);
        assertEquals(180 + Math.toDegrees(Math.atan2(4, 3)), fix.getCourse(), 1e-9);
        GPS mounted = new GPS("gps", 45, 0, 0);
        mounted.move(0, 0, 0.5);
        GpsFix spinning = new GpsSensor(mounted, 1).read(new ScriptedTruth().at(0, 0, 0, 0, 90, 0).turning(0, 2, 0));
        assertEquals("half a metre ahead of the centre, towards the north", 1, spinning.getSpeed(), 1e-12);
        assertEquals("turning left moves it to the west", 270, spinning.getCourse(), 1e-9);
    }

    @Test
    public void theCourseCountsFromNorthWhereTheRobotIs() {
        GpsSensor sensor = new GpsSensor(new GPS("gps", 80, 0, 0), 1);
        GpsFix fix = sensor.read(new ScriptedTruth().at(0, 0, 1000, 0, 0, 0).moving(1, 0, 0));
        double convergence = Geodesic.WGS84.Direct(80, 0, 90, 1000).azi2 - 90;
        assertEquals(convergence, fix.getCourse(), 1e-9);
        assertTrue(fix.getCourse() > 0.04);
    }

    @Test
    public void errorsAreMetresAndADropOutIsAnInvalidFix() {
        GPS parameters = new GPS("gps", 0, 100, 0);
        parameters.setNoise(new Noise().setBias(10));
        GpsFix fix = new GpsSensor(parameters, 1).read(new ScriptedTruth());
        assertEquals(10 / 110574.276, fix.getLatitude(), 1e-10);
        assertEquals(10 / 111319.491, fix.getLongitude(), 1e-10);
        assertEquals(110, fix.getAltitude(), 1e-9);
        parameters.setNoise(new Noise().setDropout(1));
        GpsFix none = new GpsSensor(parameters, 1).read(new ScriptedTruth());
        assertFalse(none.isValid());
        assertTrue(Double.isNaN(none.getLatitude()));
        assertEquals(ScriptedTruth.NEW_YEAR_2026, none.getTime());
    }
}
