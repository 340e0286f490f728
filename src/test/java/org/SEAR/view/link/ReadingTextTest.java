package org.SEAR.view.link;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;

import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.project.ProjectRule;
import org.SEAR.sensors.SensorType;
import org.SEAR.sensors.SensorTypes;
import org.SEAR.sensors.VectorReading;
import org.example.ThermometerSensor;
import org.junit.Rule;
import org.junit.Test;

/** Readings in words: the unit is the sensor type's, whatever the reading's class. */
public class ReadingTextTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private final SensorTypes types = SensorTypes.load();

    @Test
    public void aNumberHasTheUnitOfItsSensor() {
        assertEquals("-17.3 deg", ReadingText.words(-17.34, types.unit(new Compass("compass"))));
        assertEquals("20.5 degC", ReadingText.words(20.51, new ThermometerSensor.Type().unit()));
        assertEquals("20.5", ReadingText.words(20.51, ""));
    }

    @Test
    public void soHasAVector() {
        VectorReading vector = new VectorReading(1, -0.001, 2.25);
        assertEquals("1.00, 0.00, 2.25 rad/s", ReadingText.words(vector, types.unit(new Gyroscope("gyroscope"))));
        assertEquals("1.00, 0.00, 2.25 uT", ReadingText.words(vector, "uT"));
    }

    @Test
    public void aSwitchSaysItsUnitOrNot() {
        assertEquals("pressed", ReadingText.words(true, types.unit(new Bumper("bumper"))));
        assertEquals("not pressed", ReadingText.words(false, types.unit(new Bumper("bumper"))));
    }

    @Test
    public void everyKindOfSensorHasAUnit() {
        for (SensorType type : types.all()) {
            assertFalse(type.parameterType().getSimpleName(), type.unit().isEmpty());
        }
    }
}
