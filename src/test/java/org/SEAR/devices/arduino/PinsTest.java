// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import java.util.Set;
import java.util.TreeSet;
import org.SEAR.devices.MotorHardware;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.arduino.WireRole;
import org.junit.Test;

/** Voltages and levels at the pins. */
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
    public void anUnwiredPinFloats() {
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
    public void aNewSeedAppliesFromTheNextReset() {
        uno.pins.setMode(14, Pins.Mode.INPUT);
        int before = uno.pins.readAnalog(14);
        uno.line.seed = 2;
        uno.pins.release();
        int other = uno.pins.readAnalog(14);
        assertNotEquals(before, other);
        uno.line.seed = 1;
        assertEquals(other, uno.pins.readAnalog(14));
        uno.pins.release();
        assertEquals(before, uno.pins.readAnalog(14));
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

    /**
     * MyRobotLab's Motor service writes the direction's level and leaves the pin an input; the pull-up then holds the
     * driver's input.
     */
    @Test
    public void aDriversInputFollowsThePullUp() {
        Engine engine = new Engine();
        MotorWires wires = new MotorWires(engine);
        uno.pins.connect(7, wires.wire(WireRole.DIRECTION));
        uno.pins.connect(9, wires.wire(WireRole.PWM));
        uno.pins.release();
        uno.pins.writeDuty(9, 255);
        assertEquals(-1, engine.power, 0);
        uno.pins.write(7, true);
        assertEquals("forward by the pull-up alone", 1, engine.power, 0);
        uno.pins.write(7, false);
        assertEquals(-1, engine.power, 0);
        uno.pins.setMode(7, Pins.Mode.PULLUP);
        assertEquals(1, engine.power, 0);
        uno.pins.release();
        assertEquals("no power", 0, engine.power, 0);
    }

    /** A motor that remembers its power. */
    private static final class Engine implements MotorHardware {
        private double power;

        @Override
        public String getName() {
            return "engine";
        }

        @Override
        public void setPower(double newPower) {
            power = newPower;
        }

        @Override
        public void setSpeed(double speed) {
            throw new AssertionError("a board gives power");
        }

        @Override
        public double getSpeed() {
            return 0;
        }

        @Override
        public long getCounts() {
            return 0;
        }

        @Override
        public double getLoad() {
            return 0;
        }
    }
}
