// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;

import java.io.ByteArrayOutputStream;
import org.SEAR.Bytes;
import org.junit.Test;

/** Numbers, lengths and signs of the sensor packets, as printed in the specifications. */
public class PacketTest {
    @Test
    public void groupsHaveTheSizesOfTheSpecifications() {
        int[][] groups = {{0, 26}, {1, 10}, {2, 6}, {3, 10}, {4, 14}, {5, 12}, {6, 52}, {100, 80}, {101, 28},
            {106, 12}, {107, 9}};
        for (int[] group : groups) {
            assertEquals("group " + group[0], group[1], Packet.size(group[0]));
        }
        assertEquals(0, Packet.size(59));
        assertEquals(0, Packet.size(99));
        assertEquals(0, Packet.size(255));
    }

    @Test
    public void numbersAreInSequence() {
        int number = 7;
        for (Packet packet : Packet.values()) {
            assertEquals(number++, packet.getNumber());
            assertEquals(packet.getSize(), Packet.size(packet.getNumber()));
            assertFalse(packet.name(), packet.getMeaning().isEmpty());
        }
        assertEquals(59, number);
    }

    @Test
    public void signsAreThoseOfTheTables() {
        int[] signed = {19, 20, 23, 24, 39, 40, 41, 42, 43, 44, 54, 55, 56, 57};
        int found = 0;
        for (Packet packet : Packet.values()) {
            if (packet.isSigned()) {
                assertEquals(signed[found++], packet.getNumber());
            }
        }
        assertEquals(signed.length, found);
    }

    @Test
    public void valuesGoOutHighByteFirstAndHoldAtTheEndsOfTheirRange() {
        assertEquals("00 64", written(Packet.DISTANCE, 100));
        assertEquals("FF D3", written(Packet.ANGLE, -45));
        assertEquals("7F FF", written(Packet.DISTANCE, 40000));
        assertEquals("80 00", written(Packet.DISTANCE, -40000));
        assertEquals("9C 40", written(Packet.VOLTAGE, 40000));
        assertEquals("FF FF", written(Packet.VOLTAGE, 70000));
        assertEquals("19", written(Packet.TEMPERATURE, 25));
        assertEquals("F6", written(Packet.TEMPERATURE, -10));
        assertEquals("FF", written(Packet.INFRARED, 255));
    }

    private static String written(Packet packet, int value) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        packet.write(value, out);
        return Bytes.hex(out.toByteArray());
    }
}
