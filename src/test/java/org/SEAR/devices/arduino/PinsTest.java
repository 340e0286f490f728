package org.SEAR.devices.arduino;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.Set;
import java.util.TreeSet;
import org.SEAR.protocol.arduino.BoardModel;
import org.junit.Test;

/** What electricity does at the pins. */
public class PinsTest {
    private final Boards uno = Boards.firmata(BoardModel.UNO);

    @Test
    public void tenBitsForFiveVolts() {
        Boards.Probe probe = uno.probe(14);
        double[] volts = {0, 0.0048, 0.0049, 2.5, 4.99, 5, 7, -1};
        int[] values = {0, 0, 1, 512, 1021, 1023, 1023, 0};
        for (int i = 0; i < volts.length; i++) {
            probe.volts = volts[i];
            assertEquals(volts[i] + " V", values[i], uno.pins.readAnalog(14));
        }
    }

    @Test
    public void aPinThatNothingIsWiredToFloats() {
        uno.pins.setMode(14, Pins.Mode.INPUT);
        Set<Integer> seen = new TreeSet<>();
        for (int i = 0; i < 100; i++) {
            seen.add(uno.pins.readAnalog(14));
            assertEquals("the same at one time", uno.pins.readAnalog(14), uno.pins.readAnalog(14));
            uno.line.now += 1 / 60.0;
        }
        assertTrue(seen.toString(), seen.size() > 80);
        assertTrue(uno.pins.floats(14));
        uno.pins.setMode(14, Pins.Mode.PULLUP);
        assertEquals(1023, uno.pins.readAnalog(14));
        assertFalse(uno.pins.floats(14));
    }

    @Test
    public void aPinWithoutPwmIsHighFromHalfTheDutyOn() {
        Boards.Probe probe = uno.probe(4);
        uno.pins.writeDuty(4, 127);
        assertEquals(0, probe.level, 0);
        uno.pins.writeDuty(4, 128);
        assertEquals(1, probe.level, 0);
        uno.pins.setMode(4, Pins.Mode.INPUT);
        assertTrue(Double.isNaN(probe.level));
        uno.pins.write(4, true);
        assertEquals("a level at an input is its pull-up", Pins.Mode.PULLUP, uno.pins.mode(4));
    }
}
