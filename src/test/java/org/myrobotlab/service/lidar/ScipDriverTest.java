// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.Fuzz;
import org.SEAR.protocol.scip.Encoding;
import org.SEAR.protocol.scip.ReplyWriter;
import org.SEAR.protocol.scip.ScipStatus;
import org.junit.Test;

/** The driver of Hokuyo's scanners finds answers and scans in any bytes. */
public class ScipDriverTest {
    private final FakeLine line = new FakeLine(19200);
    private final List<String> answers = new ArrayList<>();
    private final ScipDriver driver = new ScipDriver(line, line, new int[] {19200, 115200},
        scan -> answers.add("scan of " + scan.values(3).length));

    private void ask(String command) {
        driver.ask(new ScipRequest(command, "", command, 20, 1,
            reply -> answers.add(reply.getEcho() + " " + reply.getStatus())));
    }

    private static byte[] bytes(String text) {
        return text.replace('|', '\n').getBytes(StandardCharsets.ISO_8859_1);
    }

    @Test
    public void oneCommandAfterTheOtherWithScansBetween() {
        ask("BM");
        ask("QT");
        assertEquals(1, line.sent.size());
        driver.receive(new ReplyWriter("MD0384038401000", ScipStatus.SCAN).time(5)
            .values(new int[] {1000}, Encoding.LONG).toBytes());
        driver.receive(bytes("BM|02R||"));
        driver.receive(bytes("QT|00P||"));
        assertEquals("[scan of 1, BM 02, QT 00]", answers.toString());
        assertTrue(driver.isIdle());
    }

    @Test
    public void aLostAnswerIsRequestedAgainAndThenReported() {
        ask("BM");
        driver.receive(bytes("BM|02R||"));
        ask("QT");
        driver.receive(bytes("QT|00Q||"));
        line.pass(30, driver::tick);
        assertEquals(4, line.sent.size());
        assertEquals("[no answer to QT after 3 tries at 19200 baud: is the LIDAR switched on, and is this its port "
            + "and baud rate?]", line.errors.toString());
    }

    @Test
    public void aScannerAtAnotherRateIsFound() {
        ask("PP");
        while (line.baud != 115200) {
            line.pass(0.1, driver::tick);
        }
        driver.receive(bytes("PP|00P|DMIN:20;4||"));
        assertEquals("[PP 00]", answers.toString());
        assertEquals("[115200]", line.found.toString());
    }

    @Test
    public void anInvalidScanIsAnError() {
        driver.receive(bytes("MD0384038401000|99b||"));
        assertEquals("[scan of 0]", answers.toString());
        answers.clear();
        driver.receive(new ReplyWriter("MD0384038401000", ScipStatus.SCAN).time(5)
            .values(new int[] {1000}, Encoding.SHORT).toBytes());
        assertEquals("[the LIDAR sent an invalid reply to MD0384038401000: 2 characters of values of 3 each]",
            line.errors.toString());
    }

    @Test
    public void afterAnyBytesTheNextCommandIsAnswered() {
        Random random = new Random(Fuzz.SEED);
        byte[] scan = new ReplyWriter("MD0384038401000", ScipStatus.SCAN).time(5)
            .values(new int[] {1000}, Encoding.LONG).toBytes();
        byte[][] pieces = {scan, bytes("QT|00P||"), bytes("||"), bytes("MD|99b|"), bytes("|00P|")};
        byte[] block = new byte[1000];
        for (int done = 0; done < Fuzz.BYTES; done += block.length) {
            random.nextBytes(block);
            for (int i = 0; i < 20; i++) {
                byte[] piece = pieces[random.nextInt(pieces.length)];
                System.arraycopy(piece, 0, block, random.nextInt(block.length - piece.length), piece.length);
            }
            driver.receive(block);
            line.pass(random.nextDouble(), driver::tick);
            if (done % 50_000 == 0) {
                driver.clear();
                answers.clear();
                ask("QT");
                driver.receive(bytes("||QT|00P||"));
                assertTrue("seed " + Fuzz.SEED + " after " + done + " bytes", answers.contains("QT 00"));
                line.clear();
            }
        }
    }
}
