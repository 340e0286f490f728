// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.rplidar;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.Bytes;
import org.SEAR.Golden;
import org.junit.Test;

/** Slamtec's examples, frames of real devices, and frames that third-party drivers accept. */
public class CodecTest {
    private static final Golden RPLIDAR = Golden.of("rplidar");
    private static final double ANGLE = 1 / 64.0;

    @Test
    public void requestsWithAndWithoutPayload() {
        assertEquals(RPLIDAR.get("stop"), Bytes.hex(new RplidarRequestPacket(RplidarCommand.STOP.getCode()).toBytes()));
        assertEquals(RPLIDAR.get("ask for an express scan"),
            Bytes.hex(new RplidarRequestPacket(RplidarCommand.EXPRESS_SCAN.getCode(), new byte[5]).toBytes()));
        assertEquals(RPLIDAR.get("motor at 660 of 1023"),
            Bytes.hex(new RplidarRequestPacket(0xF0, (byte) 0x94, (byte) 2).toBytes()));
        assertEquals(RPLIDAR.get("ask for the motor's control"),
            Bytes.hex(new RplidarRequestPacket(0xFF, new byte[4]).toBytes()));
    }

    @Test
    public void requestsAreFoundInNoise() {
        List<String> found = new ArrayList<>();
        RequestReader reader = new RequestReader(request -> found.add(Bytes.hex(request.toBytes())));
        for (int value : Bytes.ints("00 25 A5 50 A5 82 05 00 00 00 00 00 22 A5 82 05 00 00 00 00 00 23 A5 A5 20 "
            + "A5 F0 02 94 02 C1 A5 84 00 21 A5 52")) {
            reader.accept(value);
        }
        assertEquals("[A5 50, A5 82 05 00 00 00 00 00 22, A5 20, A5 F0 02 94 02 C1, A5 84 00 21, A5 52]",
            found.toString());
    }

    @Test
    public void descriptors() {
        String[] expected = {null, null, RPLIDAR.get("a scan follows"), RPLIDAR.get("a scan follows"),
            RPLIDAR.get("an express scan follows"), RPLIDAR.get("who it is follows"),
            RPLIDAR.get("its health follows"), RPLIDAR.get("sample rates follow")};
        for (RplidarCommand command : RplidarCommand.values()) {
            Descriptor descriptor = command.getDescriptor();
            assertEquals(expected[command.ordinal()], descriptor == null ? null : Bytes.hex(descriptor.toBytes()));
            assertEquals(command, RplidarCommand.of(command.getCode()));
        }
        assertNull(RplidarCommand.of(0xF0));
    }

    @Test
    public void nodes() {
        assertNode("3D 01 00 A0 0F", true, 15, 0, 1000);
        assertNode("3E 81 00 A0 0F", false, 15, 1, 1000);
        assertNode("3E 01 2D A0 0F", false, 15, 90, 1000);
        assertNode("BE 41 5A A5 24", false, 47, 180.5, 2345.25);
        assertNode("3E FF B3 80 BB", false, 15, 359.984375, 12000);
        assertNode("02 81 16 00 00", false, 0, 45, 0);
        assertNode("3D 19 9C 7B 05", true, 15, 312.1875, 350.75);
        assertNode("42 BB 9C 83 05", false, 16, 313.453125, 352.75);
        assertNode("41 4D 01 5F 04", true, 16, 2.59375, 279.75);
        assertNull("first and not first", Node.of(Bytes.bytes("3F 01 00 A0 0F")));
        assertNull("neither", Node.of(Bytes.bytes("3C 01 00 A0 0F")));
        assertNull("no check bit", Node.of(Bytes.bytes("3D 00 00 A0 0F")));
    }

    private static void assertNode(String hex, boolean first, int quality, double angle, double distance) {
        assertEquals(hex, Bytes.hex(Node.of(first, quality, angle, distance).toBytes()));
        Node node = Node.of(Bytes.bytes(hex));
        assertEquals(first, node.isFirst());
        assertEquals(quality, node.getQuality());
        assertEquals(angle, node.getAngle(), 0);
        assertEquals(distance, node.getDistance(), 0);
    }

    @Test
    public void capsules() {
        int[] metre = new int[32];
        Arrays.fill(metre, 1000);
        String cabins = " A0 0F A0 0F 00".repeat(16);
        assertEquals("A0 58 00 80" + cabins, Bytes.hex(Capsule.of(true, 0, metre).toBytes()));
        assertEquals("A3 5E E1 02" + cabins, Bytes.hex(Capsule.of(false, 11.52, metre).toBytes()));
        assertEquals("A6 59 80 16" + " 00".repeat(80), Bytes.hex(Capsule.of(false, 90, new int[32]).toBytes()));
        Capsule capsule = Capsule.of(Bytes.bytes("A3 5E E1 02" + cabins));
        assertFalse(capsule.isFirst());
        assertEquals(11.52, capsule.getStart(), ANGLE);
        assertEquals(1000, capsule.getDistance(31));
        assertEquals(0, capsule.getShift(31), 0);
        assertTrue(Capsule.of(Bytes.bytes("A0 58 00 80" + cabins)).isFirst());
        assertNull("checksum", Capsule.of(Bytes.bytes("A0 58 01 80" + cabins)));
        assertNull("mark", Capsule.of(Bytes.bytes("B0 58 00 80" + cabins)));
    }

    @Test
    public void samplesOfACapsuleMayLieBeside() {
        Capsule shifted = Capsule.of(Bytes.bytes("A7 5D 80 57" + " A0 0F A0 0F 11".repeat(16)));
        assertEquals(350, shifted.getStart(), 0);
        assertEquals(0.125, shifted.getShift(0), 0);
        Capsule two = Capsule.of(Bytes.bytes("A8 56 00 00 A0 0F 40 1F 98" + " 00".repeat(75)));
        assertEquals(1000, two.getDistance(0));
        assertEquals(1, two.getShift(0), 0);
        assertEquals(2000, two.getDistance(1));
        assertEquals(1.125, two.getShift(1), 0);
        assertEquals(0, two.getDistance(2));
        assertEquals("A8 56 00 00 A0 0F 40 1F 98" + " 00".repeat(75), Bytes.hex(two.toBytes()));
    }

    @Test
    public void infoAndHealth() {
        byte[] serial = Bytes.bytes(RPLIDAR.get("its number"));
        assertEquals("18 1D 01 07 EB B3 99 F6 C9 E5 9A D2 C5 E5 9C F7 17 61 34 12",
            Bytes.hex(new Info(Info.A1M8, 1, 29, 7, serial).toBytes()));
        assertEquals("model 24, firmware 1.29, hardware 7", new Info(new Info(Info.A1M8, 1, 29, 7, serial).toBytes())
            .toString());
        assertEquals("02 34 12", Bytes.hex(new Health(Health.ERROR, 0x1234).toBytes()));
        assertEquals(0x1234, new Health(Bytes.bytes("02 34 12")).getCode());
    }
}
