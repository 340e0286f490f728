// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.Odometer;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** The odometer: whole millimetres, 16 bit, cleared by take. */
public class OdometerSensorTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private final OdometerSensor sensor = ProjectRule.unread(() -> new OdometerSensor(new Odometer("odometer"), 1));
    private final ScriptedTruth truth = new ScriptedTruth();

    private void drive(double metres) {
        truth.path += metres;
        truth.advance(sensor);
    }

    @Test
    public void lookingDoesNotClearButTakingDoes() {
        drive(1.5);
        assertEquals(1500, sensor.read(truth).getMillimetres());
        assertEquals(1.5, sensor.read(truth).getMetres(), 0);
        assertEquals(1500, sensor.take(truth).getMillimetres());
        assertEquals("cleared within the same step", 0, sensor.read(truth).getMillimetres());
        drive(-0.25);
        assertEquals(-250, sensor.take(truth).getMillimetres());
    }

    @Test
    public void fractionsOfAMillimetreAreKept() {
        int sum = 0;
        for (int i = 0; i < 1000; i++) {
            drive(0.0004);
            sum += sensor.take(truth).getMillimetres();
        }
        assertEquals(400, sum, 1);
    }

    @Test
    public void unreadItStaysAtTheEndsOf16Bits() {
        drive(40);
        assertEquals(32767, sensor.read(truth).getMillimetres());
        drive(-1);
        assertEquals("as a saturated counter does", 31767, sensor.take(truth).getMillimetres());
        drive(-70);
        assertEquals(-32768, sensor.take(truth).getMillimetres());
    }

    @Test
    public void resetStartsFromZero() {
        drive(3);
        sensor.reset();
        truth.path = 0;
        truth.step = 0;
        drive(0.125);
        assertEquals(125, sensor.read(truth).getMillimetres());
    }

    @Test
    public void aReadingThatDropsOutClearsNothing() {
        Odometer parameters = new Odometer("odometer");
        parameters.setNoise(new Noise().setDropout(0.5));
        OdometerSensor lossy = new OdometerSensor(parameters, 3);
        int sum = 0;
        int lost = 0;
        for (int i = 0; i < 200; i++) {
            truth.path += 0.01;
            truth.advance(lossy);
            OdometerReading reading = lossy.take(truth);
            lost += reading.isValid() ? 0 : 1;
            sum += reading.getMillimetres();
        }
        assertTrue("" + lost, lost > 60 && lost < 140);
        assertEquals(2000, sum, 40);
    }

    @Test
    public void errorsAreInMetres() {
        Odometer parameters = new Odometer("odometer");
        parameters.setNoise(new Noise().setBias(0.1));
        OdometerSensor wrong = new OdometerSensor(parameters, 3);
        truth.path = 1;
        truth.advance(wrong);
        assertEquals(1100, wrong.read(truth).getMillimetres());
        parameters.setNoise(new Noise().setDropout(1));
        OdometerReading missing = new OdometerSensor(parameters, 3).read(truth);
        assertFalse(missing.isValid());
        assertTrue(Double.isNaN(missing.getMetres()));
    }
}
