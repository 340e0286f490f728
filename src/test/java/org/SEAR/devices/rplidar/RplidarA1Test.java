package org.SEAR.devices.rplidar;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.Bytes;
import org.SEAR.devices.FakeContext;
import org.SEAR.devices.FakeScanner;
import org.SEAR.protocol.rplidar.Capsule;
import org.SEAR.protocol.rplidar.Node;
import org.junit.Before;
import org.junit.Test;

/** The A1 against Slamtec's description and what drivers of others check. */
public class RplidarA1Test {
    private static final String SCAN = "A5 5A 05 00 00 40 81";
    private static final String EXPRESS = "A5 82 05 00 00 00 00 00 22";
    private static final int DESCRIPTOR = 7;

    private FakeContext line;
    private FakeScanner scanner;
    private RplidarA1 rplidar;

    @Before
    public void power() {
        power(1);
    }

    private void power(double resolution) {
        line = new FakeContext();
        scanner = new FakeScanner();
        line.sensor = scanner;
        rplidar = line.attach(new RplidarA1(resolution, 0.15, line));
    }

    private String ask(String hex) {
        line.take();
        line.host(hex);
        line.pass(0.1);
        return line.takeHex();
    }

    private List<Node> nodes(String request, double seconds) {
        line.take();
        line.host(request);
        line.pass(seconds);
        byte[] bytes = line.take();
        assertEquals(SCAN, Bytes.hex(Arrays.copyOf(bytes, DESCRIPTOR)));
        List<Node> nodes = new ArrayList<>();
        for (int i = DESCRIPTOR; i + Node.SIZE <= bytes.length; i += Node.SIZE) {
            nodes.add(Node.of(Arrays.copyOfRange(bytes, i, i + Node.SIZE)));
            assertNotNull("node " + i, nodes.get(nodes.size() - 1));
        }
        return nodes;
    }

    @Test
    public void itTellsWhatItIs() {
        assertEquals("A5 5A 14 00 00 00 04 18 14 01 00 EB B3 99 F6 C9 E5 9A D2 C5 E5 9C F7 17 61 34 12", ask("A5 50"));
        assertEquals("A5 5A 03 00 00 00 06 00 00 00", ask("A5 52"));
        assertEquals("A5 5A 04 00 00 00 15 F4 01 FA 00", ask("A5 59"));
    }

    @Test
    public void whatAnA1DoesNotKnowIsNotAnswered() {
        assertEquals("the motor's speed", "", ask("A5 F0 02 94 02 C1"));
        assertEquals("an accessory board", "", ask("A5 FF 04 00 00 00 00 5E"));
        assertEquals("boost, of newer firmware", "", ask("A5 82 05 03 00 00 00 00 21"));
        assertEquals("wrong checksum", "", ask("A5 82 05 00 00 00 00 00 23"));
        assertEquals("idle anyway", "", ask("A5 25"));
    }

    @Test
    public void samplesRunClockwiseFromAhead() {
        scanner.world = beam -> beam == 180 ? 1 : beam == 90 ? 2 : beam == 270 ? 3 : beam == 0 ? 4 : beam == 179 ? 0.1 : Double.POSITIVE_INFINITY;
        List<Node> nodes = nodes("A5 20", 0.5);
        assertTrue(nodes.get(0).isFirst());
        assertNode(nodes.get(0), 0, 1000, 15);
        assertNode(nodes.get(90), 90, 2000, 15);
        assertNode(nodes.get(180), 180, 4000, 15);
        assertNode(nodes.get(270), 270, 3000, 15);
        assertNode(nodes.get(1), 1, 0, 0);
        assertTrue("the next turn", nodes.get(360).isFirst());
        assertEquals("2000 a second", 980, nodes.size(), 32);
        assertEquals("[]", line.warnings.toString());
    }

    private static void assertNode(Node node, double angle, double distance, int quality) {
        assertEquals(angle, node.getAngle(), 0);
        assertEquals(distance, node.getDistance(), 0);
        assertEquals(quality, node.getQuality());
    }

    @Test
    public void theMotorsSpeedMakesTheSamplesOfATurn() {
        power(1.8);
        scanner.world = beam -> 1;
        List<Node> nodes = nodes("A5 21", 0.5);
        assertTrue(nodes.get(200).isFirst());
        assertEquals(1.8, nodes.get(1).getAngle(), 1 / 64.0);
        assertTrue(rplidar.status(), rplidar.status().contains("scan, 10.0 turns/s"));
    }

    @Test
    public void expressScansAreTwiceAsFine() {
        scanner.world = beam -> 1 + beam / 1000.0;
        line.host(EXPRESS);
        line.pass(1);
        byte[] bytes = line.take();
        assertEquals("A5 5A 54 00 00 40 82", Bytes.hex(Arrays.copyOf(bytes, DESCRIPTOR)));
        int count = (bytes.length - DESCRIPTOR) / Capsule.SIZE;
        assertEquals(124, count, 2);
        for (int i = 0; i < count; i++) {
            int at = DESCRIPTOR + i * Capsule.SIZE;
            Capsule capsule = Capsule.of(Arrays.copyOfRange(bytes, at, at + Capsule.SIZE));
            assertEquals(i == 0, capsule.isFirst());
            assertEquals(i * 16 % 360, capsule.getStart(), 0);
            int beam = Math.floorMod(360 - i * 32, 720);
            assertEquals(1000 + beam, capsule.getDistance(0));
            assertEquals(0, capsule.getShift(0), 0);
        }
    }

    @Test
    public void anotherRequestEndsTheScan() {
        scanner.world = beam -> 1;
        nodes("A5 20", 0.2);
        line.host("A5 25");
        line.pass(0.1);
        line.take();
        line.pass(0.5);
        assertEquals(0, line.take().length);
        nodes("A5 20", 0.2);
        assertTrue(ask("A5 52").endsWith("A5 5A 03 00 00 00 06 00 00 00"));
    }

    @Test
    public void resetAndPowerEndAScan() {
        scanner.world = beam -> 1;
        nodes("A5 20", 0.2);
        ask("A5 40");
        line.pass(0.1);
        assertEquals("A5 5A 03 00 00 00 06 00 00 00", ask("A5 52"));
        nodes("A5 20", 0.2);
        rplidar.powerOff();
        line.pass(1);
        rplidar.powerOn(line.now);
        assertEquals("it boots", "", ask("A5 52"));
        line.pass(1);
        assertEquals("A5 5A 03 00 00 00 06 00 00 00", ask("A5 52"));
        line.host(0xA5);
        rplidar.receiveGarbage(line.now);
        assertEquals("", ask("52"));
    }

    @Test
    public void theSameRequestsGiveTheSameBytes() {
        byte[] first = run();
        power();
        assertArrayEquals(first, run());
    }

    private byte[] run() {
        scanner.world = beam -> 1 + beam / 500.0;
        line.host("A5 50 A5 20");
        line.pass(1);
        line.host(EXPRESS);
        line.pass(1);
        return line.take();
    }
}
