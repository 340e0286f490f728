// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.rplidar;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.Bytes;
import org.SEAR.Golden;
import org.SEAR.devices.FakeContext;
import org.SEAR.devices.FakeScanner;
import org.SEAR.protocol.rplidar.Capsule;
import org.SEAR.protocol.rplidar.Node;
import org.junit.Before;
import org.junit.Test;

/** The A1 compared with Slamtec's description and the checks of third-party drivers. */
public class RplidarA1Test {
    private static final Golden RPLIDAR = Golden.of("rplidar");
    private static final String SCAN = RPLIDAR.get("a scan follows");
    private static final String EXPRESS = RPLIDAR.get("ask for an express scan");
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
    public void itReportsItsIdentity() {
        assertEquals(RPLIDAR.get("model 24, firmware 1.20, its number"), ask(RPLIDAR.get("ask who it is")));
        assertEquals(RPLIDAR.get("health: good"), ask(RPLIDAR.get("ask for its health")));
        assertEquals(RPLIDAR.get("500 us a sample, 250 of an express scan"), ask("A5 59"));
    }

    @Test
    public void unknownRequestsAreNotAnswered() {
        assertEquals("the motor's speed", "", ask(RPLIDAR.get("motor at 660 of 1023")));
        assertEquals("an accessory board", "", ask(RPLIDAR.get("ask for the motor's control")));
        assertEquals("boost, of newer firmware", "", ask(RPLIDAR.get("ask for an express scan of another mode")));
        assertEquals("wrong checksum", "", ask(RPLIDAR.get("ask for an express scan, its checksum wrong")));
        assertEquals("idle anyway", "", ask(RPLIDAR.get("stop")));
    }

    @Test
    public void samplesRunClockwiseFromAhead() {
        scanner.world = beam -> beam == 180 ? 1 : beam == 90 ? 2 : beam == 270 ? 3 : beam == 0 ? 4 : beam == 179 ? 0.1
            : Double.POSITIVE_INFINITY;
        List<Node> nodes = nodes(RPLIDAR.get("ask for a scan"), 0.5);
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

    /** Sample n of a turn, n degrees to the right, is taken n half milliseconds after the turn's start. */
    @Test
    public void samplesAreTakenOneAfterAnother() {
        nodes(RPLIDAR.get("ask for a scan"), 0.5);
        double start = scanner.times.get(180).get(0);
        for (int sample = 0; sample < 360; sample++) {
            int beam = Math.floorMod(180 - sample, 360);
            assertEquals("sample " + sample, start + sample * 0.0005, scanner.times.get(beam).get(0), 1e-9);
            assertEquals("next turn", start + 0.18 + sample * 0.0005, scanner.times.get(beam).get(1), 1e-9);
        }
        scanner.times.clear();
        ask(EXPRESS);
        assertEquals("4000 a second in an express scan", 0.00025, scanner.times.get(359).get(0) - scanner.times.get(360)
            .get(0), 1e-9);
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
        assertEquals(RPLIDAR.get("an express scan follows"), Bytes.hex(Arrays.copyOf(bytes, DESCRIPTOR)));
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
        nodes(RPLIDAR.get("ask for a scan"), 0.2);
        line.host(RPLIDAR.get("stop"));
        line.pass(0.1);
        line.take();
        line.pass(0.5);
        assertEquals(0, line.take().length);
        nodes(RPLIDAR.get("ask for a scan"), 0.2);
        assertTrue(ask(RPLIDAR.get("ask for its health")).endsWith(RPLIDAR.get("health: good")));
    }

    @Test
    public void resetAndPowerEndAScan() {
        scanner.world = beam -> 1;
        nodes(RPLIDAR.get("ask for a scan"), 0.2);
        ask("A5 40");
        line.pass(0.1);
        assertEquals(RPLIDAR.get("health: good"), ask(RPLIDAR.get("ask for its health")));
        nodes(RPLIDAR.get("ask for a scan"), 0.2);
        rplidar.powerOff();
        line.pass(1);
        rplidar.powerOn(line.now);
        assertEquals("it boots", "", ask(RPLIDAR.get("ask for its health")));
        line.pass(1);
        assertEquals(RPLIDAR.get("health: good"), ask(RPLIDAR.get("ask for its health")));
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
