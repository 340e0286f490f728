// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.scripts;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/** Recording a run by calls in lock-step, and reading the record. */
public class RecordCallsTest {
    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private SEAR sear;
    private String record;

    @Before
    public void start() {
        TestWorld.build(temporary.getRoot().toPath());
        sear = (SEAR) Runtime.start("recordSear", "SEAR");
        record = temporary.getRoot().toPath().resolve("run").toString();
    }

    @Test
    public void aRunWithDriversGivesTheSameBytesAgain() throws Exception {
        assertEquals(record + ".searlog", sear.recordRun(record));
        sear.startSimulation();
        Serial serial = (Serial) Runtime.start("recordSerial", "Serial");
        serial.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
        sear.simSleep(1);
        serial.write(new byte[] {(byte) 0x80, (byte) 0x84, (byte) 0x94, 3, 7, 19, 20});
        sear.simSleep(0.5);
        serial.write(new byte[] {(byte) 0x89, 0, (byte) 0xC8, (byte) 0x80, 0});
        sear.simSleep(1);
        sear.spin(30);
        sear.simSleep(0.5);
        sear.stopSimulation();
        String file = record + ".searlog";
        Map<String, Object> result = sear.rerunRecord(file);
        assertEquals(result.toString(), true, result.get("same"));
        assertEquals(3.0, (Double) result.get("seconds"), 0.02);
        String ports = result.get("ports").toString();
        assertTrue(ports, ports.matches("(?s).*drive at " + TestWorld.ROOMBA_PORT
            + "=[1-9][0-9]{2,} bytes, the same.*"));
        assertTrue(sear.getRecordNames(file).contains("roomba.heading"));
        assertEquals("the ending may be left out, as in recordRun", sear.getRecordNames(file),
            sear.getRecordNames(record));
        sear.saveRecordPlot(record, List.of("roomba.z"), record + ".svg");
        Map<String, Object> values = sear.getRecordValues(file, List.of("roomba.z", "ping"));
        assertEquals(((double[]) values.get("times")).length,
            ((List<?>) ((List<?>) values.get("values")).get(1)).size());
        Path csv = temporary.getRoot().toPath().resolve("run.csv");
        sear.saveRecordCsv(file, List.of("roomba.z", "ping"), csv.toString());
        assertEquals("time (s),roomba.z,ping", Files.readAllLines(csv).get(0));
        assertTrue(assertThrows(RuntimeException.class, () -> sear.saveRecordCsv(file, List.of("ping"), null))
            .getMessage().contains("run.csv"));
        Map<String, Object> frames = sear.getRecordFrames(file);
        assertEquals(List.of("roomba"), frames.get("robots"));
        List<?> words = (List<?>) frames.get("words");
        assertEquals(((List<?>) frames.get("times")).size(), words.size());
        int ping = ((List<?>) frames.get("sensors")).indexOf("ping");
        String said = (String) ((List<?>) words.get(0)).get(ping);
        assertTrue(said, said.matches("\\d\\.\\d{3} m"));
    }

    @Test
    public void aRecordMayBeginLaterAndEndBefore() {
        sear.startSimulation();
        sear.simSleep(0.5);
        sear.recordRun(record);
        assertTrue(assertThrows(IllegalStateException.class, () -> sear.recordRun(record)).getMessage()
            .contains("is being written to"));
        sear.simSleep(0.5);
        assertEquals(0.5, sear.endRecord(), 0.02);
        assertTrue(assertThrows(IllegalStateException.class, sear::endRecord).getMessage()
            .contains("no record is being written"));
        String said = assertThrows(IllegalStateException.class, () -> sear.rerunRecord(record + ".searlog"))
            .getMessage();
        assertTrue(said, said.contains("can't be run again: begin the record before the start, or after reset()"));
        sear.reset();
        sear.recordRun(record);
        sear.driveStraight(0.2);
        sear.simSleep(1);
        sear.endRecord();
        assertEquals(true, sear.rerunRecord(record + ".searlog").get("same"));
    }

    @Test
    public void anIncompleteRecordIsReadAndReported() throws Exception {
        Heard heard = (Heard) Runtime.start("recordStatus", "Heard");
        sear.addListener("publishStatus", "recordStatus", "onStatus");
        String file = sear.recordRun(record);
        sear.startSimulation();
        sear.simSleep(1);
        long deadline = System.nanoTime() + TimeUnit.MINUTES.toNanos(1);
        while (Files.size(Path.of(file)) == 0 && System.nanoTime() < deadline) {
            Thread.yield();    // a thread of its own writes the record
        }
        Map<String, Object> frames = sear.getRecordFrames(file);
        assertEquals(Map.of("whole", false, "written", true),
            Map.of("whole", frames.get("whole"), "written", frames.get("written")));
        assertTrue(heard.getStatuses().toString(),
            heard.awaitStatus(file + " is still being written: SEAR reads it up to its latest event"));
        sear.stopSimulation();
        assertEquals(true, sear.getRecordFrames(file).get("whole"));
        Path cut = temporary.getRoot().toPath().resolve("cut.searlog");
        byte[] bytes = Files.readAllBytes(Path.of(file));
        Files.write(cut, Arrays.copyOf(bytes, bytes.length - 1));
        frames = sear.getRecordFrames(cut.toString());
        assertEquals(Map.of("whole", false, "written", false),
            Map.of("whole", frames.get("whole"), "written", frames.get("written")));
        assertEquals(true, sear.rerunRecord(cut.toString()).get("same"));
        assertTrue(heard.getStatuses().toString(), heard.awaitStatus(cut + " was cut off, by a crash or a full disk"));
    }

    @Test
    public void errorsAreReported() throws Exception {
        Path other = temporary.getRoot().toPath().resolve("other.searlog");
        Files.writeString(other, "no record");
        String said = assertThrows(IllegalStateException.class, () -> sear.recordRun(other.toString())).getMessage();
        assertTrue(said, said.contains("exists and is no record of a run"));
        said = assertThrows(IllegalStateException.class, () -> sear.recordRun(temporary.getRoot() + "/none/run"))
            .getMessage();
        assertTrue(said, said.contains("there is no folder"));
        said = assertThrows(IllegalStateException.class, () -> sear.rerunRecord(other.toString())).getMessage();
        assertTrue(said, said.contains("it does not begin with \"SEARLOG1\""));
        said = assertThrows(IllegalArgumentException.class, () -> sear.recordRun(record, -1)).getMessage();
        assertTrue(said, said.contains("megabytes is -1.0, legal: above 0 to"));
    }
}
