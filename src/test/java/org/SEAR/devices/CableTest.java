// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.simulator.Simulation;
import org.junit.Test;

/** The line between a device and the user's port. */
public class CableTest {
    private static final int BAUD = 9600;
    private final Cable cable = new Cable("lidar", "LIDAR", "uart", "user");
    private final Echo device = new Echo();
    private final ByteArrayOutputStream host = new ByteArrayOutputStream();

    /** A device that sends back each byte. */
    private final class Echo implements SerialDevice {
        private final List<Double> times = new ArrayList<>();
        private final ByteArrayOutputStream heard = new ByteArrayOutputStream();
        private int garbage;
        private double timeOn;
        private int hungUp;

        @Override
        public int getBaud() {
            return BAUD;
        }

        @Override
        public void receive(int value, double time) {
            times.add(time);
            heard.write(value);
            cable.send(new byte[] {(byte) value}, time);
        }

        @Override
        public void receiveGarbage(double time) {
            garbage++;
        }

        @Override
        public void portClosed(double time) {
            hungUp++;
        }

        @Override
        public void advance(double time) {
            assertFalse("runs without power", Double.isNaN(timeOn));
        }

        @Override
        public void reset() {
            heard.reset();
        }

        @Override
        public void powerOff() {
            timeOn = Double.NaN;
        }

        @Override
        public void powerOn(double time) {
            timeOn = time;
        }

        @Override
        public boolean takesDriveCommands() {
            return true;
        }

        @Override
        public String status() {
            return "listens";
        }
    }

    public CableTest() {
        cable.attach(device);
        cable.setSink((bytes, starts) -> host.write(bytes, 0, bytes.length));
    }

    private void step(long number) {
        cable.accept(number * Simulation.STEP);
        cable.run((number + 1) * Simulation.STEP);
        cable.deliver((number + 1) * Simulation.STEP);
    }

    @Test
    public void bytesTakeTenBitsEachInBothDirections() {
        cable.write(new byte[40]);
        step(6);
        assertEquals("bytes in a step", 16, device.times.size());
        assertEquals(6 * Simulation.STEP + 10.0 / BAUD, device.times.get(0), 1e-12);
        assertEquals(10.0 / BAUD, device.times.get(5) - device.times.get(4), 1e-12);
        assertEquals("the echo of the last byte is still on its way", 15, host.size());
        step(7);
        step(8);
        step(9);
        assertEquals(40, host.size());
        assertEquals(40, cable.getWritten());
        assertEquals(40, cable.getDelivered());
    }

    @Test
    public void aNewProgramGetsNoBytesOfTheLastOne() {
        cable.send(new byte[20], 0);
        cable.hangUp();
        cable.deliver(Simulation.STEP);
        assertEquals("nobody is there", 0, host.size());
        assertEquals(0, cable.getDelivered());
        step(1);
        assertEquals("what leaves the line from now on is for the next one", 4, host.size());
        assertEquals(1, device.hungUp);
        cable.setPowered(false, 1);
        cable.hangUp();
        step(60);
        assertEquals("without power it notices nothing", 1, device.hungUp);
    }

    @Test
    public void outputIsBoundedAndLostBytesAreCounted() {
        byte[] message = new byte[500];
        for (int i = 0; i < 100; i++) {
            cable.send(message, 0);
        }
        assertEquals("nine begin while no more than 4096 bytes wait", 91 * 500, cable.takeLost());
        assertEquals(0, cable.takeLost());
        for (int i = 0; i < 300; i++) {
            step(i);
        }
        assertEquals(9 * 500, host.size());
        cable.send(message, 301 * Simulation.STEP);
        for (int i = 301; i < 340; i++) {
            step(i);
        }
        assertEquals("an empty line takes the next", 10 * 500, host.size());
        assertEquals(0, cable.takeLost());
    }

    @Test
    public void bytesWaitingForTheDeviceAreReported() {
        cable.write(new byte[40]);
        assertEquals(40, cable.getWaiting());
        step(0);
        assertEquals(24, cable.getWaiting());
        step(1);
        step(2);
        assertEquals(0, cable.getWaiting());
    }

    @Test
    public void aBaudMismatchGivesGarbageBothWays() {
        cable.setHostBaud(19200);
        cable.write(new byte[] {1, 2, 3});
        step(0);
        assertEquals(3, device.garbage);
        cable.send(new byte[] {0x10, 0x20}, Simulation.STEP);
        step(1);
        assertEquals(2, host.size());
        assertTrue(host.toByteArray()[0] != 0x10);
        cable.setHostBaud(BAUD);
        cable.write(new byte[] {5});
        step(2);
        assertArrayEquals(new byte[] {5}, device.heard.toByteArray());
    }

    @Test
    public void aFloodIsBoundedAndAcceptedBytesStayInOrder() {
        byte[] flood = new byte[Cable.MAX_WAITING + 1000];
        for (int i = 0; i < flood.length; i++) {
            flood[i] = (byte) (i * 31);
        }
        cable.write(flood);
        cable.write(flood);
        assertEquals(Cable.MAX_WAITING, cable.getWritten());
        assertEquals(flood.length + 1000L, cable.takeDropped());
        for (int i = 0; i < 100; i++) {
            step(i);
            cable.write(new byte[] {9});
        }
        byte[] heard = device.heard.toByteArray();
        for (int i = 0; i < heard.length; i++) {
            assertEquals(flood[i], heard[i]);
        }
        assertEquals(1600, heard.length, 2);
    }

    @Test
    public void withoutPowerTheDeviceIsSilentAndDeaf() {
        cable.write(new byte[40]);
        step(0);
        int heard = device.heard.size();
        int said = host.size();
        assertTrue(heard > said && said > 0);
        cable.setPowered(false, Simulation.STEP);
        assertEquals("off", cable.status());
        assertFalse(cable.isPowered() || cable.takesDriveCommands());
        cable.write(new byte[] {1, 2, 3});
        for (int i = 1; i < 60; i++) {
            step(i);
        }
        assertEquals("what waited and what came are gone", heard, device.heard.size());
        assertEquals("what was on the line is gone", said, host.size());
        assertEquals(0, cable.getWaiting());
        cable.setPowered(true, 1);
        assertEquals(1, device.timeOn, 0);
        assertEquals("listens", cable.status());
        cable.write(new byte[] {4});
        step(60);
        step(61);
        assertEquals(said + 1, host.size());
        assertEquals(4, host.toByteArray()[said]);
    }

    @Test
    public void aResetSwitchesThePowerOn() {
        cable.setPowered(false, 0);
        cable.restart();
        device.timeOn = 0;
        assertTrue(cable.isPowered() && cable.takesDriveCommands());
        step(0);
    }

    @Test
    public void outputIsCutBehindTheByteThatIsOnTheLine() {
        cable.send(new byte[] {1, 2, 3, 4, 5, 6, 7, 8}, 0);
        double half = 2.5 * 10 / BAUD;
        cable.cutOutput(half);
        assertEquals(3 * 10.0 / BAUD, cable.freeAt(), 1e-12);
        cable.send(new byte[] {9}, half);
        cable.deliver(1);
        assertArrayEquals(new byte[] {1, 2, 3, 9}, host.toByteArray());
        cable.cutOutput(2);
        cable.send(new byte[] {10, 11}, 2);
        cable.cutOutput(2);
        assertEquals("nothing was on the line yet", 2, cable.freeAt(), 0);
        cable.deliver(3);
        assertEquals(4, host.size());
    }

    @Test
    public void theReceiverLearnsWhereMessagesBegin() {
        List<String> pieces = new ArrayList<>();
        cable.setSink((bytes, starts) -> pieces.add(bytes.length + " " + Arrays.toString(starts)));
        cable.send(new byte[20], 0);
        cable.send(new byte[2], 0);
        cable.send(new byte[1], 0);
        cable.send(new byte[300], 0);
        for (int step = 1; step <= 3; step++) {
            cable.deliver(step * Simulation.STEP + 1e-6);
        }
        assertEquals(List.of("16 [0]", "16 [4, 6, 7]", "16 []"), pieces);
        cable.cutOutput(3 * Simulation.STEP + 1e-6);
        cable.send(new byte[5], 3 * Simulation.STEP + 1e-6);
        cable.deliver(4 * Simulation.STEP);
        assertEquals("the rest of the cut message is one byte", "6 [1]", pieces.get(3));
    }
}
