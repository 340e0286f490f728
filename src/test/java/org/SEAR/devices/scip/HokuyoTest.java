// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.scip;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.Golden;
import org.SEAR.devices.FakeContext;
import org.SEAR.devices.FakeScanner;
import org.SEAR.protocol.scip.Encoding;
import org.SEAR.protocol.scip.HokuyoModel;
import org.SEAR.protocol.scip.Reply;
import org.SEAR.protocol.scip.ReplyReader;
import org.junit.Before;
import org.junit.Test;

/**
 * The scanners compared with examples of the specification and the checks of third-party drivers; {@code |} is a line
 * feed.
 */
public class HokuyoTest {
    private static final Golden SCIP = Golden.of("scip");
    private FakeContext line;
    private FakeScanner scanner;
    private Hokuyo hokuyo;

    @Before
    public void urg() {
        power(HokuyoModel.URG_04LX);
    }

    private void power(HokuyoModel model) {
        line = new FakeContext();
        scanner = new FakeScanner();
        line.sensor = scanner;
        hokuyo = line.attach(new Hokuyo(model, model.isUsbOnly() ? HokuyoModel.USB : 115200, line));
    }

    private String ask(String command) {
        return ask(command, 1);
    }

    private String ask(String command, double seconds) {
        line.take();
        line.hostText(command + "\n");
        line.pass(seconds);
        return line.takeText().replace('\n', '|');
    }

    private List<Reply> replies(String command, double seconds) {
        line.take();
        line.hostText(command + "\n");
        line.pass(seconds);
        List<Reply> replies = new ArrayList<>();
        new ReplyReader(replies::add, () -> replies.add(null)).accept(line.take());
        return replies;
    }

    @Test
    public void itReportsItsIdentity() {
        assertEquals(SCIP.get("parameters of an URG-04LX"),
            ask("PP"));
        assertEquals(SCIP.get("version of an URG-04LX, up to its last checksum"),
            ask("VV").replaceAll(";.\\|\\|$", ";"));
        String state = ask("II");
        assertTrue(state, state.contains("|LASR:OFF;7|SCSP:Initial(600[rpm])<-Default setting by user;A|MESM:IDLE;:|"));
        assertTrue(state, state.endsWith("|STAT:Sensor works well.;8||"));
        power(HokuyoModel.UTM_30LX);
        assertTrue(ask("PP").endsWith(
            "|DMIN:23;7|DMAX:60000;J|ARES:1440;^|AMIN:0;?|AMAX:1080;Z|AFRT:540;0|SCAN:2400;U||"));
        assertTrue(ask("II").contains("|SBPS:USB only;n|"));
    }

    /** Step s of a turn of 100 ms is measured s / 1024 turns after step 0, at which the time stamp is taken. */
    @Test
    public void stepsAreMeasuredOneAfterAnother() {
        List<Reply> replies = replies("MD0044072501001", 1);
        int stamp = replies.get(1).time();
        for (int step = 44; step <= 725; step++) {
            assertEquals("step " + step, stamp / 1000.0 + step * 0.1 / 1024, scanner.times.get(step - 384 + 341)
                .get(0), 1e-9);
        }
    }

    @Test
    public void theLaserIsOffUntilItIsSwitchedOn() {
        assertEquals(SCIP.get("a scan by GD while the laser is off"), ask("GD0384038601"));
        assertEquals(SCIP.get("laser on"), ask("BM"));
        assertEquals(SCIP.get("laser on already"), ask("BM"));
        scanner.world = beam -> 1 + (beam - 341) / 1000.0;
        List<Reply> replies = replies("GD0384038601", 1);
        assertArrayEquals(new int[] {1000, 1001, 1002}, replies.get(0).values(Encoding.LONG));
        assertEquals(SCIP.get("stop"), ask("QT"));
        assertEquals(SCIP.get("a scan by GD while the laser is off"), ask("GD0384038601"));
    }

    @Test
    public void aCommandIsEchoedWithItsString() {
        assertEquals(SCIP.get("laser on, with a comment"), ask("BM;my own name"));
        assertEquals(SCIP.get("stop, with the longest comment"), ask("QT;0123456789012345"));
        assertEquals(SCIP.get("stop, with a comment that is too long"), ask("QT;01234567890123456"));
        assertEquals("QT\u0001|0Hh||", ask("QT\u0001"));
        assertEquals(SCIP.get("no such command"), ask("ME0000108001000"));
        assertEquals("Q|0Ee||", ask("Q"));
        assertEquals(SCIP.get("a command that is too short"), ask("MD00440725"));
        assertEquals(SCIP.get("steps beyond the end"), ask("MD0044076901000"));
        assertEquals("", ask("\r"));
    }

    @Test
    public void aFiniteStreamCountsDownAndSwitchesTheLaserOff() {
        List<Reply> replies = replies("MD0380038801003", 1);
        assertEquals(4, replies.size());
        assertEquals("MD0380038801003", replies.get(0).getEcho());
        assertEquals("00", replies.get(0).getStatus());
        for (int i = 1; i <= 3; i++) {
            assertEquals("MD03800388010" + String.format("%02d", 3 - i), replies.get(i).getEcho());
            assertTrue(replies.get(i).isScan());
        }
        assertEquals(100, replies.get(2).time() - replies.get(1).time());
        assertTrue(hokuyo.status(), hokuyo.status().startsWith("URG-04LX: laser off"));
    }

    @Test
    public void anEndlessStreamComesTenTimesASecondAndEndsAtQt() {
        List<Reply> replies = replies("MD0380038800000", 2.05);
        assertEquals(21, replies.size(), 1);
        assertEquals("MD0380038800000", replies.get(20).getEcho());
        assertEquals("interval 1: each second scan", 11, replies("MD0380038800100", 2.05).size(), 1);
        ask("QT");
        assertEquals("", ask("\n"));
        power(HokuyoModel.UTM_30LX);
        assertEquals(41, replies("MD0000108001000", 1.01).size(), 1);
    }

    @Test
    public void scansBeyondTheLinesCapacityAreSkipped() {
        List<Reply> replies = replies("MD0044072501000", 4);
        assertFalse("no broken one but the last", replies.subList(0, replies.size() - 1).contains(null));
        assertEquals("185.5 ms each: every second one", 200, replies.get(3).time() - replies.get(2).time());
        assertEquals(SCIP.get("stop"), ask("QT").replaceAll(".*QT", "QT"));
    }

    @Test
    public void anglesRunFromRightToLeftWithTheFrontAtItsStep() {
        scanner.world = beam -> beam / 100.0;
        int[] values = replies("MD0000076801001", 3).get(1).values(Encoding.LONG);
        assertEquals(769, values.length);
        assertEquals("not measured", 19, values[43]);
        assertEquals("44 is 340 steps to the right of the front, the fan begins one step before", 10,
            10 * (44 - 384 + 341));
        assertEquals("too near", 6, values[44]);
        assertEquals(3410, values[384]);
        assertEquals("beyond 5.6 m", 0, values[384 + 341]);
        assertEquals("not measured", 19, values[726]);
    }

    @Test
    public void aClusterHasTheNearestRangeOfItsSteps() {
        scanner.world = beam -> beam == 342 ? 0.7 : beam == 345 ? Double.POSITIVE_INFINITY : 2;
        List<Reply> replies = replies("MS0384039203001", 1);
        assertArrayEquals(new int[] {700, 2000, 2000}, replies.get(1).values(Encoding.SHORT));
        scanner.world = beam -> 5;
        assertArrayEquals("two characters end at 4095", new int[] {4095}, replies("MS0384038401001", 1).get(1)
            .values(Encoding.SHORT));
        scanner.world = beam -> Double.POSITIVE_INFINITY;
        assertArrayEquals(new int[] {0}, replies("MD0384038602001", 1).get(1).values(Encoding.LONG));
        power(HokuyoModel.UTM_30LX);
        scanner.world = beam -> beam == 540 ? 0.01 : Double.POSITIVE_INFINITY;
        assertArrayEquals("too near, nothing", new int[] {2, 1}, replies("MD0540054101001", 1).get(1)
            .values(Encoding.LONG));
    }

    @Test
    public void theRateChangesAfterTheReply() {
        assertEquals(SCIP.get("115200 baud, which it has"), ask("SS115200"));
        assertEquals(SCIP.get("a baud rate that there is not"), ask("SS123456"));
        assertEquals(SCIP.get("a baud rate that is no number"), ask("SS12x456"));
        assertEquals(SCIP.get("19200 baud"), ask("SS019200"));
        assertEquals(19200, hokuyo.getBaud());
        assertEquals(SCIP.get("reset"), ask("RS"));
        assertEquals("the rate of power-on", 115200, hokuyo.getBaud());
        assertFalse(hokuyo.hearsEveryBaud());
        power(HokuyoModel.UTM_30LX);
        assertEquals("SS115200|04T||", ask("SS115200"));
        assertTrue(hokuyo.hearsEveryBaud());
    }

    @Test
    public void theClockCanBeReadWhileAdjusting() {
        assertEquals(SCIP.get("clock: not begun"), ask("TM1"));
        assertEquals(SCIP.get("clock: begin to set it"), ask("TM0"));
        assertEquals(SCIP.get("clock: begun already"), ask("TM0"));
        assertEquals("QT|0Ee||", ask("QT"));
        List<Reply> replies = replies("TM1", 0.1);
        assertEquals(4000, replies.get(0).time(), 20);
        assertEquals(SCIP.get("clock: end"), ask("TM2"));
        assertEquals(SCIP.get("clock: ended already"), ask("TM2"));
        assertEquals(SCIP.get("clock: no such step"), ask("TM3"));
        ask("RS");
        ask("TM0");
        assertEquals("the clock began anew", 2000, replies("TM1", 0.1).get(0).time(), 20);
    }

    @Test
    public void theMotorTurnsSlower() {
        assertEquals("CR10|00P||", ask("CR10"));
        assertEquals("CR10|03S||", ask("CR10"));
        assertEquals("CR11|01Q||", ask("CR11"));
        List<Reply> replies = replies("MD0384038401003", 1);
        assertEquals(111, replies.get(2).time() - replies.get(1).time(), 1);
        assertTrue(ask("II").contains("SCSP:Initial(540[rpm])"));
        assertEquals("CR99|00P||", ask("CR99"));
        assertEquals("HS1|00P||", ask("HS1"));
        assertEquals("HS1|02R||", ask("HS1"));
        power(HokuyoModel.UTM_30LX);
        assertEquals("CR05|04T||", ask("CR05"));
    }

    /** State that a driver killed between TM0 and TM2 leaves. */
    @Test
    public void aResetEndsTheAdjustingOfItsClock() {
        for (String reset : new String[] {"RS", "RT"}) {
            assertEquals(SCIP.get("clock: begin to set it"), ask("TM0"));
            assertEquals("BM|0Ee||", ask("BM"));
            assertEquals("QT|0Ee||", ask("QT"));
            assertEquals(reset + "|00P||", ask(reset));
            assertEquals(SCIP.get("laser on"), ask("BM"));
            assertEquals(SCIP.get("clock: not begun"), ask("TM1"));
        }
        power(HokuyoModel.UTM_30LX);
        ask("TM0");
        assertEquals("of a UTM-30LX QT does, too", SCIP.get("stop"), ask("QT"));
        assertEquals(SCIP.get("laser on"), ask("BM"));
    }

    @Test
    public void withoutPowerItForgets() {
        replies("MD0384038401000", 1);
        ask("SS019200");
        hokuyo.powerOff();
        line.pass(1);
        hokuyo.powerOn(line.now);
        line.take();
        assertEquals("it boots", "", ask("VV"));
        line.pass(2);
        assertEquals(115200, hokuyo.getBaud());
        assertTrue(ask("II").contains("|LASR:OFF;7|"));
        line.host(0x51);
        hokuyo.receiveGarbage(line.now);
        assertEquals(SCIP.get("laser on"), ask("BM"));
    }

    @Test
    public void theSameCommandsGiveTheSameBytes() {
        byte[] first = run();
        power(HokuyoModel.URG_04LX);
        assertArrayEquals(first, run());
    }

    private byte[] run() {
        scanner.world = beam -> 1 + beam / 500.0;
        line.hostText("VV\nII\nMD0044072501000\n");
        line.pass(3);
        line.hostText("QT\nII\n");
        line.pass(1);
        byte[] bytes = line.take();
        assertTrue(new String(bytes, StandardCharsets.ISO_8859_1).contains("MD0044072501000\n99b\n"));
        return bytes;
    }
}
