// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Noise;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** Compass headings: clockwise from north, which is +X by default; an unrotated robot looks east (+Z). */
public class CompassSensorTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static double heading(Compass compass, ScriptedTruth truth) {
        return new CompassSensor(compass, 1).read(truth).get();
    }

    @Test
    public void headingsGoClockwiseFromNorth() {
        Compass compass = new Compass("compass");
        assertEquals("east", 90, heading(compass, new ScriptedTruth()), 1e-9);
        assertEquals("north", 0, heading(compass, new ScriptedTruth().at(0, 0, 0, 0, 90, 0)), 1e-9);
        assertEquals("west", -90, heading(compass, new ScriptedTruth().at(0, 0, 0, 0, 180, 0)), 1e-9);
        assertEquals("south is +180", 180, heading(compass, new ScriptedTruth().at(0, 0, 0, 0, -90, 0)), 1e-9);
        assertEquals(90 - 30, heading(compass, new ScriptedTruth().at(0, 0, 0, 0, 30, 0)), 1e-9);
        for (int angle = -720; angle <= 720; angle += 7) {
            double heading = heading(compass, new ScriptedTruth().at(0, 0, 0, 0, angle, 0));
            assertTrue(heading > -180 && heading <= 180);
            assertEquals(0, Math.IEEEremainder(90 - angle - heading, 360), 1e-9);
        }
    }

    @Test
    public void southIsAlwaysPlus180() {
        assertEquals(180, CompassSensor.wrap(-180), 0);
        assertEquals(180, CompassSensor.wrap(540), 0);
        assertEquals(-179.5, CompassSensor.wrap(180.5), 0);
        assertEquals("0.0", String.valueOf(CompassSensor.wrap(-360)));
    }

    @Test
    public void tiltingForwardDoesNotTurnIt() {
        assertEquals(90, heading(new Compass("compass"), new ScriptedTruth().at(0, 0, 0, 40, 0, 0)), 1e-9);
        assertEquals("straight down there is no heading", 0,
            heading(new Compass("compass"), new ScriptedTruth().at(0, 0, 0, 90, 0, 0)), 91);
    }

    @Test
    public void theMountTurnsIt() {
        Compass compass = new Compass("compass");
        compass.rotate(0, 45, 0);
        assertEquals("45 degrees to the left of east", 45, heading(compass, new ScriptedTruth()), 1e-9);
    }

    @Test
    public void northIsAPointOfTheWorld() {
        Compass compass = new Compass("compass");
        compass.setNorth(0, 50, 10);
        assertEquals("north is at +Z", 0, heading(compass, new ScriptedTruth()), 1e-9);
        assertEquals("from beside it, north is at +X", 90,
            heading(compass, new ScriptedTruth().at(-5, 0, 10, 0, 0, 0)), 1e-9);
        assertEquals("at the point itself the direction from the origin counts", 0,
            heading(compass, new ScriptedTruth().at(0, 3, 10, 0, 0, 0)), 1e-9);
    }

    @Test
    public void magneticHeadingIsTrueHeadingMinusDeclination() {
        ScriptedTruth truth = new ScriptedTruth();
        truth.epoch = 1735689600000L;
        truth.earth = new Earth(new GeoOrigin(-80, 0, -120), MagneticModel.standard());
        assertEquals(90 - 68.78, heading(new Compass("compass", true), truth), 0.01);
        assertEquals(90, heading(new Compass("compass", false), truth), 1e-9);
        truth.epoch = 1814356800000L;
        assertEquals("half 2027", 90 - 68.49, heading(new Compass("compass", true), truth), 0.01);
        truth.at(0, 100000, 0, 0, 0, 0);
        assertEquals("100 km up", 90 - 67.93, heading(new Compass("compass", true), truth), 0.01);
    }

    @Test
    public void itWarnsOutsideTheModelsYearsAndWithoutAPlace() {
        CompassSensor sensor = new CompassSensor(new Compass("north", true), 1);
        ScriptedTruth truth = new ScriptedTruth();
        assertTrue(sensor.warnings(truth).get(0).contains("compass north shows true north"));
        assertEquals(90, sensor.read(truth).get(), 1e-9);
        truth.earth = new Earth(new GeoOrigin(35, 200, -80), MagneticModel.standard());
        assertTrue(sensor.warnings(truth).isEmpty());
        truth.epoch = 1924992000000L;
        assertEquals("compass north: WMM-2025 is valid from 2025.0 to 2030.0, the simulated date is 2031.0; the "
            + "declination is less accurate;"
            + " put that year's coefficients into assets/WMM.COF", sensor.warnings(truth).get(0));
        assertTrue(new CompassSensor(new Compass("other"), 1).warnings(truth).isEmpty());
    }

    @Test
    public void errorsWrapAndADropOutIsNotANumber() {
        Compass compass = new Compass("compass");
        compass.setNoise(new Noise().setBias(100));
        assertEquals(-170, heading(compass, new ScriptedTruth()), 1e-9);
        compass.setNoise(new Noise().setDropout(1));
        assertTrue(Double.isNaN(heading(compass, new ScriptedTruth())));
    }
}
