// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.protocol.rplidar.Capsule;
import org.SEAR.protocol.rplidar.Node;
import org.SEAR.protocol.rplidar.RplidarCommand;
import org.junit.Test;

/** The driver of the RPLIDAR finds answers and whole turns in any bytes. */
public class RplidarDriverTest {
    private static final byte[] HEALTH = Bytes.bytes("A5 5A 03 00 00 00 06 00 00 00");
    private static final byte[] SCAN = Bytes.bytes("A5 5A 05 00 00 40 81");
    private static final byte[] EXPRESS = Bytes.bytes("A5 5A 54 00 00 40 82");

    private final FakeLine line = new FakeLine(115200);
    private final List<RangeScan> scans = new ArrayList<>();
    private final List<String> answers = new ArrayList<>();
    private final RplidarDriver driver = new RplidarDriver(line, line, new int[] {115200},
        turn -> scans.add(RplidarTurn.scan(turn, 360, 0)));

    private void ask(RplidarCommand command, boolean wholeTurn) {
        driver.ask(new RplidarRequest(command.name(), command, wholeTurn, 1, bytes -> answers.add(command.name())));
    }

    private void node(boolean first, double angle, double millimetres) {
        driver.receive(Node.of(first, 15, angle, millimetres).toBytes());
    }

    @Test
    public void turnsRunRightToLeftFromBehind() {
        ask(RplidarCommand.SCAN, true);
        driver.receive(SCAN);
        node(false, 350, 1);
        for (double angle = 0; angle < 360; angle += 45) {
            node(angle == 0, angle, 1000 + angle);
        }
        assertEquals("[]", answers.toString());
        node(true, 0, 5);
        assertEquals("[SCAN]", answers.toString());
        assertEquals("[-90.0, -45.0, 0.0, 45.0, 90.0, 135.0, 180.0, 225.0]", Arrays.toString(scans.get(0).angles));
        assertEquals("[1180, 1135, 1090, 1045, 1000, 1315, 1270, 1225]", Arrays.toString(scans.get(0).raw));
        assertEquals(45, scans.get(0).resolution, 0);
        assertEquals(315, scans.get(0).spread, 0);
    }

    @Test
    public void missingSamplesAreNoDistance() {
        ask(RplidarCommand.SCAN, false);
        driver.receive(SCAN);
        assertEquals("[SCAN]", answers.toString());
        node(true, 0, 0);
        node(false, 90, 16000);
        node(true, 0, 0);
        RangeScan scan = scans.get(0);
        assertEquals("[0.0, 90.0]", Arrays.toString(scan.angles));
        assertEquals(16, scan.metres[0], 0);
        assertNull(scan.metres[1]);
    }

    @Test
    public void capsulesAreInterpolatedToTheNext() {
        ask(RplidarCommand.EXPRESS_SCAN, false);
        driver.receive(EXPRESS);
        int[] metre = new int[32];
        Arrays.fill(metre, 1000);
        for (int i = 0; i < 47; i++) {
            driver.receive(Capsule.of(i == 0, i * 16, metre).toBytes());
        }
        assertEquals(1, scans.size());
        assertEquals(720, scans.get(0).raw.length);
        assertEquals(-90, scans.get(0).angles[0], 1e-9);
        assertEquals(0.5, scans.get(0).angles[1] - scans.get(0).angles[0], 1e-9);
    }

    @Test
    public void theRestOfAScanBeforeAnAnswerIsLeftOut() {
        ask(RplidarCommand.SCAN, false);
        driver.receive(SCAN);
        ask(RplidarCommand.STOP, false);
        assertFalse(line.sent.contains("A5 52"));
        ask(RplidarCommand.GET_HEALTH, false);
        assertEquals("a pause after STOP", "[A5 20, A5 25]", line.sent.toString());
        line.pass(1.1, driver::tick);
        assertEquals("[A5 20, A5 25, A5 52]", line.sent.toString());
        driver.receive(Bytes.bytes("3E 81 00 A0 0F 3E"));
        driver.receive(HEALTH);
        assertEquals("[SCAN, GET_HEALTH]", answers.toString());
    }

    @Test
    public void aLostByteCostsAFewSamples() {
        ask(RplidarCommand.SCAN, false);
        driver.receive(SCAN);
        node(true, 0, 1000);
        driver.receive(Bytes.bytes("81 00 A0 0F"));
        for (int i = 2; i < 100; i++) {
            node(false, i, 1000);
        }
        node(true, 0, 1000);
        assertEquals(100, scans.get(0).raw.length, 3);
    }

    @Test
    public void silenceIsAnError() {
        ask(RplidarCommand.GET_HEALTH, false);
        line.pass(30, driver::tick);
        assertTrue(line.errors.toString(), line.errors.get(0).startsWith("no answer to GET_HEALTH after"));
        assertTrue(driver.isIdle());
    }

    @Test
    public void afterAnyBytesTheNextRequestIsAnswered() {
        Random random = new Random(Fuzz.SEED);
        byte[][] pieces = {SCAN, EXPRESS, HEALTH, Node.of(true, 1, 0, 1).toBytes(), Node.of(false, 1, 180, 1).toBytes(),
            Capsule.of(false, 90, new int[32]).toBytes(), Capsule.of(false, 300, new int[32]).toBytes()};
        RplidarCommand[] commands = {RplidarCommand.SCAN, RplidarCommand.EXPRESS_SCAN, RplidarCommand.GET_INFO};
        byte[] block = new byte[1000];
        for (int done = 0; done < Fuzz.BYTES; done += block.length) {
            random.nextBytes(block);
            for (int i = 0; i < 20; i++) {
                byte[] piece = pieces[random.nextInt(pieces.length)];
                System.arraycopy(piece, 0, block, random.nextInt(block.length - piece.length), piece.length);
            }
            driver.receive(block);
            line.pass(random.nextDouble(), driver::tick);
            if (done % 10_000 == 0) {
                driver.clear();
                answers.clear();
                scans.clear();
                ask(RplidarCommand.GET_HEALTH, false);
                driver.receive(HEALTH);
                assertTrue("seed " + Fuzz.SEED + " after " + done + " bytes", answers.contains("GET_HEALTH"));
                line.clear();
                ask(commands[random.nextInt(commands.length)], random.nextBoolean());
            }
        }
    }
}
