// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.protocol.lms.LmsCommand;
import org.SEAR.protocol.lms.OperatingMode;
import org.junit.Test;

/** The driver sends one request at a time, repeats it, gives up, and searches the device at other rates. */
public class LmsDriverTest {
    private static final String SCAN_REQUEST = "02 00 02 00 30 01 31 18";
    private static final byte[] MODE_REPLY = Bytes.bytes("06 02 80 03 00 A0 00 10 16 0A");
    private static final byte[] SCAN_REPLY = Bytes.bytes("06 02 80 06 00 B0 01 40 D2 24 10 B0 99");

    private final List<String> answers = new ArrayList<>();
    private final FakeLine line = new FakeLine(9600);
    private final LmsDriver driver = new LmsDriver(line, line, telegram -> answers.add("streamed"));

    private void askScan() {
        driver.ask(new LmsRequest("a scan", LmsCommand.SCAN, () -> LmsCommand.SCAN.request().add(1), 813, 1,
            reply -> answers.add("scan")));
    }

    private void askMode() {
        driver.ask(new LmsRequest("streaming", LmsCommand.MODE, () -> LmsCommand.MODE.request()
            .add(OperatingMode.STREAM_ALL), 9, 3, reply -> answers.add("mode")));
    }

    @Test
    public void theNextRequestWaitsForThePreviousAnswer() {
        askScan();
        askMode();
        assertEquals(1, line.sent.size());
        driver.receive(SCAN_REPLY);
        assertEquals(2, line.sent.size());
        driver.receive(MODE_REPLY);
        assertEquals("[scan, mode]", answers.toString());
        assertTrue(driver.isIdle());
    }

    @Test
    public void afterAnyBytesTheNextScanIsAnswered() {
        Random random = new Random(Fuzz.SEED);
        byte[][] telegrams = {MODE_REPLY, SCAN_REPLY, {0x02, (byte) 0x80}, {0x06}, {0x15}};
        byte[] block = new byte[1000];
        for (int done = 0; done < Fuzz.BYTES; done += block.length) {
            random.nextBytes(block);
            for (int i = 0; i < 20; i++) {
                byte[] piece = telegrams[random.nextInt(telegrams.length)];
                System.arraycopy(piece, 0, block, random.nextInt(block.length - piece.length), piece.length);
            }
            driver.receive(block);
            line.pass(random.nextDouble(), driver::tick);
            if (done % 50_000 == 0) {
                driver.clear();
                answers.clear();
                askScan();
                driver.receive(SCAN_REPLY);
                assertTrue("seed " + Fuzz.SEED + " after " + done + " bytes", answers.contains("scan"));
                line.clear();
            }
        }
    }

    @Test
    public void anAnswerThatInterruptsAScanIsFoundAfterAPause() {
        askMode();
        driver.receive(Bytes.bytes("02 80 D6 02 B0 69 41 15 15 15 15 06 15 15"));
        driver.receive(MODE_REPLY);
        line.pass(0.5, driver::tick);
        assertEquals("[mode]", answers.toString());
        assertEquals(1, line.sent.size());
        assertTrue(line.errors.isEmpty());
    }

    @Test
    public void pausedTimeCausesNoTimeout() {
        askScan();
        for (int i = 0; i < 100_000; i++) {
            driver.tick();
        }
        assertEquals(1, line.sent.size());
    }

    @Test
    public void aRefusedRequestIsRepeatedAfterThePause() {
        askScan();
        driver.receive(Bytes.bytes("15"));
        driver.tick();
        assertEquals(1, line.sent.size());
        line.pass(0.05, driver::tick);
        assertEquals(2, line.sent.size());
        assertEquals(SCAN_REQUEST, line.sent.get(1));
        driver.receive(SCAN_REPLY);
        assertEquals("[scan]", answers.toString());
        assertTrue(line.errors.isEmpty());
    }

    @Test
    public void threeRefusalsAreAnError() {
        askScan();
        for (int i = 0; i < 3; i++) {
            driver.receive(Bytes.bytes("15"));
            line.pass(0.05, driver::tick);
        }
        assertEquals(3, line.sent.size());
        assertTrue(line.errors.toString(), line.errors.get(0).contains("NAK"));
        assertTrue(driver.isIdle());
    }

    @Test
    public void silenceAfterEarlierDataCausesARepeatAndThenAnError() {
        askMode();
        driver.receive(MODE_REPLY);
        askScan();
        line.pass(30, driver::tick);
        assertEquals(4, line.sent.size());
        assertTrue(line.errors.toString(),
            line.errors.get(0).contains("no answer to a scan after 3 tries at 9600 baud"));
        askScan();
        assertEquals("after an error it takes requests again", 5, line.sent.size());
    }

    @Test
    public void aDeviceLeftAtAnotherRateIsFound() {
        askScan();
        while (line.baud != 38400) {
            line.pass(0.1, driver::tick);
        }
        driver.receive(SCAN_REPLY);
        assertEquals("[38400]", line.found.toString());
        assertEquals("[scan]", answers.toString());
        assertEquals("[the LIDAR answers at 38400 baud]", line.infos.toString());
        assertTrue(line.errors.isEmpty());
    }

    @Test
    public void aMissingDeviceIsReportedOnce() {
        askScan();
        askMode();
        line.pass(120, driver::tick);
        assertEquals(line.errors.toString(), 1, line.errors.size());
        assertTrue(driver.isIdle());
    }

    @Test
    public void streamedScansAreNotAnswers() {
        driver.receive(SCAN_REPLY);
        askMode();
        driver.receive(SCAN_REPLY);
        driver.receive(MODE_REPLY);
        assertEquals("[streamed, streamed, mode]", answers.toString());
    }

    @Test
    public void aForbiddenRequestIsAnErrorAndTheNextFollows() {
        askScan();
        askMode();
        driver.receive(Bytes.bytes("06 02 80 02 00 92 10 7F 33"));
        assertTrue(line.errors.get(0).contains("does not permit a scan"));
        assertEquals(2, line.sent.size());
    }

    @Test
    public void theDriverWaitsAfterAChangeOfBaudRate() {
        driver.changeBaud(38400);
        askScan();
        assertEquals(0, line.sent.size());
        line.pass(0.3, driver::tick);
        assertEquals(1, line.sent.size());
        assertEquals(38400, line.baud);
    }

    @Test(expected = IllegalStateException.class)
    public void aScriptFasterThanTheDeviceIsReported() {
        for (int i = 0; i < 200; i++) {
            askScan();
        }
    }
}
