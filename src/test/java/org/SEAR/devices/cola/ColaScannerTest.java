// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.cola;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import org.SEAR.Bytes;
import org.SEAR.Golden;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.devices.FakeContext;
import org.SEAR.devices.FakeScanner;
import org.SEAR.project.ProjectRule;
import org.SEAR.protocol.cola.ColaDialect;
import org.SEAR.protocol.lidar.LidarModel;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.LidarSource;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.Truth;
import org.junit.Before;
import org.junit.Test;

/** LMS111 and TiM561 compared with recorded telegrams and the requests of their drivers. */
public class ColaScannerTest {
    private static final Golden COLA = Golden.of("cola");
    private static final String LOGIN = COLA.get("log in as authorized client");
    private static final int FIRST_VALUE = 26;

    private FakeContext line;
    private FakeScanner scanner;
    private ColaScanner device;

    @Before
    public void power() {
        power(LidarModel.LMS111, 270, 0.5, beam -> 1 + beam / 1000.0);
    }

    private void power(LidarModel model, double spread, double resolution, IntToDoubleFunction world) {
        line = new FakeContext();
        scanner = new FakeScanner();
        scanner.world = world;
        line.sensor = scanner;
        device = line.attach(new ColaScanner(ColaModel.of(model), spread, resolution, model.getBaud(), line));
    }

    private void send(String telegram) {
        line.hostText("\u0002" + telegram + "\u0003");
    }

    /** Returns the answer in CoLa A without its frame; several answers are separated by |. */
    private String ask(String telegram) {
        line.take();
        send(telegram);
        line.pass(0.017);
        return text();
    }

    private String text() {
        return new String(line.take(), StandardCharsets.ISO_8859_1).replace("\u0003\u0002", "|")
            .replaceAll("[\u0002\u0003]", "");
    }

    private String askB(String hex) {
        line.take();
        line.host(hex);
        line.pass(0.017);
        return line.takeHex();
    }

    private static void head(String[] scan, String frequency, String beams, String start, String step, String count) {
        assertEquals("1 1", scan[2] + " " + scan[3]);
        assertEquals("0 0", scan[5] + " " + scan[6]);
        assertEquals("0 " + frequency + " " + beams + " 0 1 DIST1 3F800000 00000000 " + start + " " + step
            + " " + count, String.join(" ", Arrays.copyOfRange(scan, 15, FIRST_VALUE)));
    }

    /** The mirror turns 50 times per second: 0.5 degrees in 27.8 us. A scan's end is a multiple of 20 ms. */
    @Test
    public void beamsAreMeasuredOneAfterAnother() {
        ask(LOGIN);
        line.pass(0.1);
        ask(COLA.get("ask for a scan"));
        double last = scanner.times.get(540).get(0);
        assertEquals(0, Math.IEEEremainder(last, 0.02), 1e-9);
        assertTrue(last <= line.now && last > line.now - 0.04);
        for (int beam = 0; beam <= 540; beam++) {
            assertEquals("beam " + beam, last - (540 - beam) * 0.02 / 720, scanner.times.get(beam).get(0), 1e-9);
        }
    }

    @Test
    public void mrptsConversation() {
        assertEquals(COLA.get("logged in"), ask(LOGIN));
        assertEquals(COLA.get("25 Hz, a quarter of a degree: done"),
            ask(COLA.get("25 Hz, a quarter of a degree, decimal")));
        assertEquals(COLA.get("what scans have: done"), ask(COLA.get("distances without remissions")));
        assertEquals(COLA.get("measuring"), ask(COLA.get("start measuring")));
        assertTrue(ask(COLA.get("ask for the state")).matches("sRA STlms 7 0 8 00:00:00 A 01\\.01\\.1970 0 0 0"));
        String[] scan = ask(COLA.get("ask for a scan")).split(" ");
        head(scan, "9C4", "168", "FFF92230", "9C4", "439");
        assertEquals("7 0", scan[13] + " " + scan[14]);
        for (int beam = 0; beam < 1081; beam++) {
            assertEquals("beam " + beam, 1000 + beam, Integer.parseInt(scan[FIRST_VALUE + beam], 16));
        }
        assertEquals("0 0 0 0 0 0", String.join(" ", Arrays.copyOfRange(scan, FIRST_VALUE + 1081, scan.length)));
    }

    @Test
    public void theLms1xxLibrarysConversation() {
        assertEquals(COLA.get("logged in"), ask(LOGIN));
        assertEquals(COLA.get("50 Hz, half a degree, 270 degrees"), ask(COLA.get("ask for frequency and resolution")));
        assertEquals(COLA.get("270 degrees, each half"), ask(COLA.get("ask for the range of angles")));
        assertEquals(COLA.get("what scans have: done"), ask(COLA.get("distances and remissions")));
        assertEquals(COLA.get("measuring"), ask(COLA.get("start measuring")));
        assertTrue(ask(COLA.get("ask for the state")).startsWith("sRA STlms 7"));
        assertEquals(COLA.get("it runs"), ask(COLA.get("run")));
        assertTrue(ask(COLA.get("stream scans")).startsWith("sEA LMDscandata 1"));
        line.take();
        line.pass(0.0201);
        String[] scan = text().split(" ");
        assertEquals("sSN LMDscandata", scan[0] + " " + scan[1]);
        assertEquals("distances and remissions", "2 DIST1", scan[19] + " " + scan[20]);
        assertEquals("RSSI1 3F800000 00000000 FFF92230 1388 21D",
            String.join(" ", Arrays.copyOfRange(scan, 26 + 541, 32 + 541)));
        assertEquals("0 0 0 0 0 0", String.join(" ", Arrays.copyOfRange(scan, 32 + 2 * 541, scan.length)));
        line.pass(1);
        assertEquals("50 Hz", 50, text().split("sSN LMDscandata", -1).length - 1, 1);
        ask(COLA.get("end the stream"));
        line.pass(1);
        assertEquals("", text());
    }

    @Test
    public void sickScansConversationInBinary() {
        power(LidarModel.TIM561, 270, 1 / 3.0, beam -> 2);
        assertEquals(COLA.get("CoLa B: logged in"),
            askB(COLA.get("CoLa B: log in")));
        assertEquals(COLA.get("CoLa B: it speaks CoLa B"),
            askB(COLA.get("CoLa B: speak CoLa B")));
        assertEquals("V2.60 with its length", COLA.get("CoLa B: firmware 2.60, without frame"),
            payload(askB(binary(COLA.get("ask for the firmware")))));
        assertEquals("ready", COLA.get("CoLa B: ready, without frame"), payload(askB(binary("sRN SCdevicestate"))));
        assertEquals(COLA.get("CoLa B: 270 degrees, each third, without frame"),
            payload(askB(binary(COLA.get("ask for the range of angles")))));
        assertTrue(askB(COLA.get("CoLa B: stream scans"))
            .startsWith(COLA.get("CoLa B: scans are streamed")));
        line.take();
        line.pass(1 / 15.0);
        byte[] scan = line.take();
        assertEquals("sSN LMDscandata ", new String(scan, 8, 16, StandardCharsets.US_ASCII));
        assertEquals("outputs, reserved, 15 Hz, 16.2 kHz, encoders, one channel",
            "01 00 00 00 00 00 05 DC 00 00 00 A2 00 00 00 01", Bytes.hex(Arrays.copyOfRange(scan, 48, 64)));
        assertEquals("DIST1", new String(scan, 64, 5, StandardCharsets.US_ASCII));
        assertEquals("-45 degrees, a third of a degree, 811 values of 2000", "FF F9 22 30 0D 05 03 2B 07 D0",
            Bytes.hex(Arrays.copyOfRange(scan, 77, 87)));
        assertEquals("four bytes of length and nine around it", scan.length - 9, (scan[6] & 0xFF) << 8
            | scan[7] & 0xFF);
    }

    private static String binary(String request) {
        return Bytes.hex(ColaDialect.B.frame(request.getBytes(StandardCharsets.US_ASCII)));
    }

    private static String payload(String telegram) {
        return telegram.substring(8 * 3, telegram.length() - 3);
    }

    @Test
    public void itsIdentity() {
        assertEquals(COLA.get("an LMS111"), ask(COLA.get("ask for the device")));
        assertEquals(COLA.get("no name"), ask(COLA.get("ask for the name")));
        assertEquals(COLA.get("firmware 1.36"), ask(COLA.get("ask for the firmware")));
        power(LidarModel.TIM561, 270, 1 / 3.0, beam -> 2);
        assertEquals(COLA.get("a TiM561"), ask(COLA.get("ask for the device by its number")));
        assertEquals(COLA.get("the serial number"), ask(COLA.get("ask for the serial number")));
        assertEquals("sRA ODpwrc 1", ask("sRN ODpwrc"));
        assertEquals("sRA ODoprh 0", ask("sRN ODoprh"));
    }

    @Test
    public void refusals() {
        assertEquals("write access", COLA.get("no access to a variable"), ask(COLA.get("180 degrees, each half")));
        assertEquals("access", COLA.get("no access to a method"), ask(COLA.get("50 Hz, half a degree")));
        assertEquals(COLA.get("not measuring"), ask(COLA.get("start measuring")));
        assertEquals(COLA.get("not logged in"), ask(COLA.get("log in with a wrong password")));
        assertEquals("sFA 2", ask("sMN NoSuchThing"));
        assertEquals("sFA 3", ask("sRN NoSuchThing"));
        assertEquals("sFA F", ask("sEN NoSuchThing 1"));
        assertEquals("sFA C", ask("sXN STlms"));
        ask(LOGIN);
        assertEquals("sFA 8", ask("sWN LocationName"));
        assertEquals("sFA 8", ask("sWN LocationName 5 abc"));
        assertEquals("sFA 11", ask("sMN SetAccessMode x"));
        assertEquals("sFA 5", ask("sWN LMDscandatacfg 00 00 0 1 0 00 00 0 0 0 0 +1"));
        assertEquals("beyond 225 degrees", "sFA 5", ask("sWN LMPoutputRange 1 1388 0 225511"));
        assertEquals("a resolution that it doesn't have", "sFA 5", ask("sWN LMPoutputRange 1 1389 0 225510"));
        assertEquals("an LMS1xx' method", "sFA 2", tim(COLA.get("25 Hz, a quarter of a degree, decimal")));
    }

    private String tim(String request) {
        power(LidarModel.TIM561, 270, 1 / 3.0, beam -> 2);
        ask(LOGIN);
        return ask(request);
    }

    @Test
    public void ratesThatAnLms1xxDoesNotHaveAreRefusedWithTheirReason() {
        ask(LOGIN);
        String present = " 1388 1 1388 FFF92230 225510";
        assertEquals("frequency", "sAN mLMPsetscancfg 1" + present,
            ask("sMN mLMPsetscancfg +3000 +1 +5000 -450000 +2250000"));
        assertEquals("resolution", "sAN mLMPsetscancfg 2" + present,
            ask("sMN mLMPsetscancfg +5000 +1 +1000 -450000 +2250000"));
        assertEquals("both", "sAN mLMPsetscancfg 3" + present,
            ask("sMN mLMPsetscancfg +5000 +1 +2500 -450000 +2250000"));
        assertEquals("area", "sAN mLMPsetscancfg 4" + present,
            ask("sMN mLMPsetscancfg +5000 +1 +5000 -450001 +2250000"));
        assertEquals("sectors", "sAN mLMPsetscancfg 5" + present,
            ask("sMN mLMPsetscancfg +5000 +2 +5000 -450000 +2250000"));
        assertEquals("sAN mLMPsetscancfg 0 9C4 1 1388 FFF92230 225510",
            ask("sMN mLMPsetscancfg 9C4 1 1388 FFF92230 225510"));
    }

    /** Measures 10 m plus 1 cm per degree to the left of the forward axis, with as many beams as the real sensor. */
    private static final class AngleScanner extends Sensor<LidarScan> implements LidarSource {
        AngleScanner() {
            super(ProjectRule.unread(() -> new LIDAR("angles")), 0, 1);
        }

        @Override
        public LidarScan scan(Truth truth, double spread, double resolution) {
            assertTrue(spread + " " + resolution, resolution <= spread && spread <= 360);
            double[] ranges = new double[(int) Math.floor(spread / resolution + 1e-9) + 1];
            Arrays.setAll(ranges, beam -> 10 + (beam * resolution - spread / 2) / 100);
            return new LidarScan(spread, resolution, Double.POSITIVE_INFINITY, ranges);
        }

        @Override
        protected LidarScan measure(Truth truth) {
            return scan(truth, 180, 1);
        }
    }

    /** The scanner sends exactly the beams of the requested fan, wherever it begins. */
    @Test
    public void anyPartOfTheFanIsSent() {
        line = new FakeContext();
        line.sensor = new AngleScanner();
        device = line.attach(new ColaScanner(ColaModel.LMS111, 270, 0.5, LidarModel.LMS111.getBaud(), line));
        ask(LOGIN);
        int[][] ranges = {{-450000, 2250000}, {0, 1800000}, {900000, 900000}, {1000000, 2250000}, {-450000, -445000},
            {895000, 900000},
            {123400, 987600}};
        for (int[] range : ranges) {
            assertEquals("sWA LMPoutputRange", ask("sWN LMPoutputRange 1 1388 " + hex(range[0]) + " " + hex(range[1])));
            double first = range[0] / 10000.0 - 90;
            int count = (range[1] - range[0]) / 5000 + 1;
            String[] scan = ask(COLA.get("ask for a scan")).split(" ");
            assertEquals(hex(range[0]), scan[23]);
            assertEquals(count, Integer.parseInt(scan[25], 16));
            for (int i = 0; i < count; i++) {
                assertEquals(10000 + (first + i * 0.5) * 10, Integer.parseInt(scan[FIRST_VALUE + i], 16), 0.51);
            }
        }
    }

    /**
     * Fans whose spread and resolution no real scanner has: first beams, last beam, number of beams and the last
     * distance.
     */
    @Test
    public void anArbitraryFanIsSent() {
        double[][] fans = {{360, 0.01}, {360, 6.5535}, {45, 5}, {7.25, 0.7}, {120, 1 / 3.0}, {359.9, 0.1234}};
        for (double[] fan : fans) {
            line = new FakeContext();
            line.sensor = new AngleScanner();
            device = line.attach(new ColaScanner(ColaModel.COLA, fan[0], fan[1], LidarModel.COLA.getBaud(), line));
            String[] scan = ask(COLA.get("ask for a scan")).split(" ");
            int count = (int) Math.floor(fan[0] / fan[1] + 1e-6) + 1;
            String start = hex(900000 - (int) Math.round(fan[0] * 5000));
            head(scan, "3E8", hex((int) Math.round(36 / fan[1])), start, hex((int) Math.round(fan[1] * 10000)),
                hex(count));
            for (int i = 0; i < count; i += Math.max(1, count / 50)) {
                assertEquals(10000 + (-fan[0] / 2 + i * fan[1]) * 10,
                    Integer.parseInt(scan[FIRST_VALUE + i], 16), 0.51);
            }
        }
        assertEquals("sFA 2", ask(COLA.get("25 Hz, a quarter of a degree, decimal")));
    }

    private static String hex(int value) {
        return Integer.toHexString(value).toUpperCase();
    }

    @Test
    public void unmeasurableRangesAreZero() {
        power(LidarModel.LMS111, 270, 0.5,
            beam -> new double[] {0.499, 0.5, 20, 20.0004, 20.001, Double.POSITIVE_INFINITY}[beam % 6]);
        String[] scan = ask(COLA.get("ask for a scan")).split(" ");
        assertEquals("0 1F4 4E20 4E20 0 0", String.join(" ", Arrays.copyOfRange(scan, FIRST_VALUE, FIRST_VALUE + 6)));
    }

    @Test
    public void theContentOfAScanIsSelectable() {
        ask(LOGIN);
        ask("sWN LMPoutputRange 1 1388 DBBA0 DBBA0");
        ask("sWN LocationName 5 front");
        ask("sWN LMDscandatacfg 03 00 1 0 0 00 00 1 1 1 1 +2");
        assertEquals("sRA LMDscandatacfg 3 0 1 0 0 0 0 1 1 1 1 2", ask("sRN LMDscandatacfg"));
        String[] scan = ask(COLA.get("ask for a scan")).split(" ");
        assertEquals("two channels of 16 bit, two of 8, name and time", "2 DIST1 3F800000 00000000 DBBA0 1388 1 3E9 "
            + "DIST2 3F800000 00000000 DBBA0 1388 1 0 2 RSSI1 3F800000 00000000 DBBA0 1388 1 64 RSSI2 3F800000 "
            + "00000000 DBBA0 1388 1 0 "
            + "0 1 5 front 0 1 7EA 1 1 C 0 0", String.join(" ", Arrays.copyOfRange(scan, 19, scan.length - 2)));
        ask(COLA.get("stream scans"));
        line.take();
        line.pass(1);
        assertEquals("every second one", 25, text().split("sSN LMDscandata", -1).length - 1, 1);
    }

    /** Drivers ask for the input state; the form is that of SICK's own emulator. */
    @Test
    public void nothingIsWiredToTheInputs() {
        line.pass(1);
        assertTrue(ask("sRN LIDinputstate").matches("sRA LIDinputstate 0 F4[0-9A-F]{3} 0 0 0 0 0"));
        assertTrue(payload(askB(binary("sRN LIDinputstate")))
            .matches("73 52 41 20 4C 49 44 69 6E 70 75 74 73 74 61 74 65 20 "
            + "00 00 00 0F [0-9A-F]{2} [0-9A-F]{2} 00 00 00 00 00 00"));
    }

    @Test
    public void noFieldIsTaught() {
        power(LidarModel.TIM561, 270, 1 / 3.0, beam -> 2);
        assertEquals("73 52 41 20 66 69 65 6C 64 30 30 30 20 3F 80 00 00 00 00 00 00 00 00 0D 05 FF F9 22 30 02 01 00 "
            + "01 00 00 00 00 00 00 00 00 "
            + "00 01 00 08 46 69 65 6C 64 30 30 31 00 00", payload(askB(binary("sRN field000"))));
        assertTrue(payload(askB(binary("sRN field047"))).endsWith("46 69 65 6C 64 30 34 38 00 00"));
        assertEquals("there is no such one", "sFA 3", ask("sRN field048"));
    }

    @Test
    public void standbyAndStart() {
        ask(LOGIN);
        assertEquals("sAN LMCstandby 0", ask("sMN LMCstandby"));
        assertTrue(ask(COLA.get("ask for the state")).startsWith("sRA STlms 3"));
        assertEquals("sRA SCdevicestate 0", ask("sRN SCdevicestate"));
        assertEquals("no scan", "sFA 4", ask(COLA.get("ask for a scan")));
        assertEquals(COLA.get("measuring"), ask(COLA.get("start measuring")));
        assertTrue(ask(COLA.get("ask for the state")).startsWith("sRA STlms 5"));
        line.pass(8);
        assertTrue(ask(COLA.get("ask for the state")).startsWith("sRA STlms 7"));
        assertEquals("sAN LMCstopmeas 0", ask("sMN LMCstopmeas"));
        assertTrue(ask(COLA.get("ask for the state")).startsWith("sRA STlms 4"));
        ask(COLA.get("start measuring"));
        line.pass(1);
        assertEquals("sRA SCdevicestate 1", ask("sRN SCdevicestate"));
    }

    @Test
    public void settingsAreKeptWithoutPowerOnlyIfTheyWereWritten() {
        ask(LOGIN);
        ask(COLA.get("180 degrees, each half"));
        assertEquals("sAN mEEwriteall 1", ask("sMN mEEwriteall"));
        ask(COLA.get("25 Hz, a quarter of a degree, decimal"));
        device.powerOff();
        device.powerOn(line.now);
        assertTrue(device.status(), device.status().endsWith("booting"));
        assertEquals("it boots", "", ask(COLA.get("ask for the state")));
        line.pass(15);
        assertTrue(ask(COLA.get("ask for the state")).startsWith("sRA STlms 7 0 8 00:00:15"));
        assertEquals(COLA.get("50 Hz, half a degree, 270 degrees"), ask(COLA.get("ask for frequency and resolution")));
        assertEquals("sRA LMPoutputRange 1 1388 0 1B7740", ask(COLA.get("ask for the range of angles")));
        ask(LOGIN);
        assertEquals("sAN mSCloadfacdef", ask("sMN mSCloadfacdef"));
        assertEquals(COLA.get("270 degrees, each half"), ask(COLA.get("ask for the range of angles")));
        assertEquals("sAN mSCreboot", ask("sMN mSCreboot"));
        assertEquals("it boots", "", ask(COLA.get("ask for the state")));
    }

    @Test
    public void theFanStartsAsInTheObject() {
        power(LidarModel.LMS111, 100, 0.25, beam -> 2);
        assertEquals("sRA LMPscancfg 9C4 1 9C4 FFF92230 225510", ask(COLA.get("ask for frequency and resolution")));
        assertEquals("sRA LMPoutputRange 1 9C4 61A80 155CC0", ask(COLA.get("ask for the range of angles")));
        head(ask(COLA.get("ask for a scan")).split(" "), "9C4", "168", "61A80", "9C4", "191");
        assertEquals("LMS111: 401 beams every 0.25 degrees, 25.0 Hz, measuring", device.status());
    }

    /** The newest scan stays the same until the next measurement. */
    @Test
    public void countersAndTimes() {
        line.pass(2);
        String[] first = ask(COLA.get("ask for a scan")).split(" ");
        String[] second = ask(COLA.get("ask for a scan")).split(" ");
        assertEquals(1, Integer.parseInt(second[7], 16) - Integer.parseInt(first[7], 16));
        assertEquals(line.now * 50, Integer.parseInt(second[8], 16), 3);
        assertEquals(line.now, Integer.parseInt(second[10], 16) / 1e6, 0.04);
        int scans = scanner.scans;
        for (int i = 0; i < 10; i++) {
            send(COLA.get("ask for a scan"));
        }
        line.pass(0.012);
        assertTrue("ten requests, " + (scanner.scans - scans) + " scans", scanner.scans - scans <= 2);
    }

    @Test
    public void loginAndStreamEndWithTheConnection() {
        ask(LOGIN);
        ask(COLA.get("stream scans"));
        line.hostText("\u0002sRN ST");
        device.portClosed(line.now);
        line.take();
        line.pass(1);
        assertEquals("", text());
        assertEquals(COLA.get("no access to a variable"), ask(COLA.get("180 degrees, each half")));
    }

    @Test
    public void anUnfinishedRequestIsForgotten() {
        line.hostText("\u0002\u0002\u0002\u0002");
        line.host("00 00 03 00 73");
        line.pass(1.1);
        assertEquals("sRA SCdevicestate 1", ask("sRN SCdevicestate"));
        assertTrue(device.hearsEveryBaud());
        assertFalse(device.takesDriveCommands());
    }
}
