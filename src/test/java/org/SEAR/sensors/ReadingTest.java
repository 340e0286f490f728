// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.List;
import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.IMU;
import org.SEAR.project.ProjectRule;
import org.example.ThermometerSensor;
import org.junit.Rule;
import org.junit.Test;

/** Text, numbers and units of readings; the unit belongs to the sensor type. */
public class ReadingTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private final SensorTypes types = SensorTypes.load();

    @Test
    public void aNumberHasTheUnitOfItsSensor() {
        assertEquals("-17.3 deg", new Quantity(-17.34, 1).words(types.unit(new Compass("compass"))));
        assertEquals("20.51 degC", new Quantity(20.51).words(new ThermometerSensor.Type().unit()));
        assertEquals("20.51", new Quantity(20.51).words(""));
        assertEquals("0.0 deg", new Quantity(-0.01, 1).words("deg"));
        assertEquals(-17.34, new Quantity(-17.34, 1).value());
    }

    @Test
    public void aNumberOfWhichNothingIsKnownHasSixDigits() {
        assertEquals("0.333333 V", new Quantity(1 / 3.0).words("V"));
        assertEquals("1234570 Pa", new Quantity(1234567).words("Pa"));
        assertEquals("0 m", new Quantity(0).words("m"));
        assertEquals("6.62607E-34 J", new Quantity(6.62607e-34).words("J"));
        assertEquals("NaN m", new Quantity(Double.NaN).words("m"));
        assertEquals("Infinity m", new Quantity(Double.POSITIVE_INFINITY).words("m"));
    }

    @Test
    public void aVectorHasItsUnitOnceAndIsATextForScripts() {
        VectorReading vector = new VectorReading(1, -0.0001, 2.25);
        assertEquals("1.000, 0.000, 2.250 rad/s", vector.words(types.unit(new Gyroscope("gyroscope"))));
        assertEquals("1.0,-1.0E-4,2.25", vector.value());
        assertEquals(List.of(".x", ".y", ".z"), vector.names());
    }

    @Test
    public void aSwitchHasTextsForBothStates() {
        String unit = types.unit(new Bumper("bumper"));
        assertEquals("pressed", new Switch(true).words(unit));
        assertEquals("not pressed", new Switch(false).words(unit));
        assertEquals("as a record has kept it", "pressed", new Switch(false).words(new double[] {1}, unit));
        assertEquals(true, new Switch(true).value());
        assertArrayEquals(new double[] {1}, new Switch(true).numbers(), 0);
        assertEquals("closed to ground", 0, new Switch(true).volts(), 0);
        assertTrue(Double.isNaN(new Switch(false).volts()));
    }

    @Test
    public void aScanIsItsNearestDistanceInRecordsAndItsRangesForScripts() {
        LidarScan scan = new LidarScan(2, 1, 8, new double[] {3, 1.25, Double.POSITIVE_INFINITY});
        assertEquals("nearest 1.250 m, 2 of 3 beams hit", scan.words("m"));
        assertEquals("nothing within 8 m", new LidarScan(2, 1, 8, new double[] {Double.POSITIVE_INFINITY}).words("m"));
        assertEquals("nearest 2.000 m", scan.words(new double[] {2}, "m"));
        assertEquals("nothing within 8 m", scan.words(new double[] {Double.POSITIVE_INFINITY}, "m"));
        assertArrayEquals(new float[] {3, 1.25f, 8}, (float[]) scan.value(), 0);
        assertArrayEquals(new double[] {1.25}, scan.numbers(), 0);
        assertArrayEquals(scan.ranges(), scan.beams(), 0);
    }

    @Test
    public void anglesAndColoursAreNamed() {
        double[] none = new double[3];
        assertEquals("yaw 1.0, pitch -2.0, roll 3.5 deg", new ImuReading(new double[] {1, -2, 3.5}, none, none, none)
            .words(types.unit(new IMU("imu"))));
        assertEquals("red 255, green 128, blue 0", new ColorReading(255, 128, 0).words("of 255"));
        assertEquals("35.1234568, -97.5000000 deg, 350.25 m", new GpsFix(35.12345678, -97.5, 350.25, 0, 0, 0)
            .words("deg, deg, m"));
    }

    /** A reading class needs nothing besides its numbers. */
    @Test
    public void numbersAreEnough() {
        Reading two = () -> new double[] {1, 2.5};
        assertArrayEquals(new double[] {1, 2.5}, (double[]) two.value(), 0);
        assertEquals("1, 2.5 V", two.words("V"));
        assertEquals(List.of(".1", ".2"), two.names());
        Reading one = () -> new double[] {4};
        assertEquals(4.0, one.value());
        assertEquals(List.of(""), one.names());
        Reading many = () -> new double[] {3, 1, 2, 9, 4, 5, 6, 7, 8};
        assertEquals("1 to 9 V", many.words("V"));
        assertNull(many.beams());
        assertNull(many.hits());
        assertNull(many.picture());
        assertTrue("it leaves pins alone", Double.isNaN(many.volts()));
        assertEquals("and sends no sound", Double.POSITIVE_INFINITY, many.echo(), 0);
    }

    @Test
    public void aPictureIsARectangle() {
        Picture picture = new Picture(2, 0xFF0000, 0x00FF00, 0x0000FF, 0, 1, 2);
        assertEquals(2, picture.getWidth());
        assertEquals(3, picture.getHeight());
        assertArrayEquals(new int[] {0xFF0000, 0x00FF00, 0x0000FF, 0, 1, 2}, picture.getPixels());
        String said = assertThrows(IllegalArgumentException.class, () -> new Picture(2, 0, 1, 2)).getMessage();
        assertTrue(said, said.contains("3 pixels in rows of 2") && said.contains("legal: "));
    }

    @Test
    public void everyKindOfSensorHasAUnit() {
        for (SensorType type : types.all()) {
            assertFalse(type.parameterType().getSimpleName(), type.unit().isEmpty());
        }
    }
}
