// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.Bytes;
import org.SEAR.Golden;
import org.SEAR.devices.FakeContext;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.ubx.NavPvt;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;
import org.SEAR.protocol.ubx.UbxReader;
import org.SEAR.sensors.GpsFix;
import org.junit.Before;
import org.junit.Test;

/** The receiver's answers, byte for byte, to requests of gpsd and other programs. */
public class NeoM8nTest {
    private static final Golden UBX = Golden.of("ubx");
    private static final String PVT_ON = UBX.get("position, velocity and time with each solution");
    private static final String SAVE = masks(0, 0x1F, 0);
    private static final String FORGET = masks(0x1F, 0, 0x1F);

    private FakeContext line;
    private NeoM8n gps;

    @Before
    public void power() {
        power(0);
    }

    private void power(double timeToFix) {
        line = new FakeContext();
        line.reading = new GpsFix(47 + 17.11399 / 60, 8 + 33.91590 / 60, 499.6, 3, 30, 0.25, FakeContext.EPOCH);
        gps = line.attach(new NeoM8n(9600, 1, timeToFix, line));
        line.pass(1.7);
        line.take();
    }

    private static String masks(int clear, int save, int load) {
        return Bytes.hex(new UbxFrame(UbxMessage.CFG_CFG, UbxFrame.room(12).putInt(clear).putInt(save).putInt(load)
            .array()).toBytes());
    }

    private String ask(String hex) {
        line.take();
        line.host(hex);
        return line.takeHex();
    }

    private List<UbxFrame> frames() {
        List<UbxFrame> found = new ArrayList<>();
        new UbxReader(found::add, other -> { }).feed(line.take());
        return found;
    }

    private byte[] poll(UbxMessage message) {
        line.take();
        line.host(Bytes.hex(new UbxFrame(message).toBytes()));
        List<UbxFrame> answers = frames();
        assertEquals(message.toString(), 1, answers.size());
        assertEquals(message, answers.get(0).getMessage());
        return answers.get(0).getPayload();
    }

    private static String frame(UbxMessage message, int... payload) {
        byte[] bytes = new byte[payload.length];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) payload[i];
        }
        return Bytes.hex(new UbxFrame(message, bytes).toBytes());
    }

    @Test
    public void itGreetsAndThenSendsSixKindsOfSentences() {
        line = new FakeContext();
        line.reading = new GpsFix(47 + 17.11399 / 60, 8 + 33.91590 / 60, 499.6, 3, 30, 0);
        line.attach(new NeoM8n(9600, 1, 0, line));
        line.pass(0.9);
        String greeting = line.takeText();
        assertTrue(greeting, greeting.startsWith("$GNTXT,01,01,02,u-blox AG - www.u-blox.com*4E\r\n"));
        assertTrue(greeting, greeting.contains("PROTVER=18.00"));
        line.pass(0.15);
        List<String> lines = List.of(line.takeText().split("\r\n"));
        assertEquals("[GNRMC, GNVTG, GNGGA, GNGSA, GNGSA, GPGSV, GPGSV, GLGSV, GNGLL]",
            lines.stream().map(each -> each.substring(1, 6)).collect(Collectors.toList()).toString());
        assertTrue(lines.stream().allMatch(each -> Nmea.body(each) != null));
        assertTrue(lines.toString(), lines.get(0)
            .startsWith("$GNRMC,120001.00,A,4717.11399,N,00833.91590,E,5.832,30.00,010126,,,A*"));
        assertTrue(lines.toString(), lines.get(1).startsWith("$GNVTG,30.00,T,,M,5.832,N,10.800,K,A*"));
        assertTrue(lines.toString(), lines.get(2)
            .startsWith("$GNGGA,120001.00,4717.11399,N,00833.91590,E,1,12,1.02,499.6,M,48.2,M,,*"));
        assertTrue(lines.toString(), lines.get(4).startsWith("$GNGSA,A,3,66,73,81,82,,,,,,,,,1.88,1.02,1.58*"));
        assertTrue(lines.toString(), lines.get(8).startsWith("$GNGLL,4717.11399,N,00833.91590,E,120001.00,A,A*"));
    }

    /** NEO-6 and NEO-M8 send the same, except for the talker. */
    @Test
    public void withoutAFixItSendsEmptyFields() {
        power(100);
        line.pass(1);
        List<String> lines = List.of(line.takeText().split("\r\n"));
        assertEquals(Nmea.sentence("GNRMC,,V,,,,,,,,,,N"), lines.get(0) + "\r\n");
        assertEquals(Nmea.sentence("GNVTG,,,,,,,,,N"), lines.get(1) + "\r\n");
        assertEquals(Nmea.sentence("GNGGA,,,,,,0,00,99.99,,,,,,"), lines.get(2) + "\r\n");
        assertEquals(Nmea.sentence("GNGSA,A,1,,,,,,,,,,,,,99.99,99.99,99.99"), lines.get(3) + "\r\n");
        assertEquals(Nmea.sentence("GPGSV,1,1,00"), lines.get(5) + "\r\n");
        assertEquals(Nmea.sentence("GNGLL,,,,,,V,N"), lines.get(7) + "\r\n");
        byte[] pvt = poll(UbxMessage.NAV_PVT);
        assertEquals(0, NavPvt.FIX_TYPE.get(pvt));
        assertEquals(9999, NavPvt.PDOP.get(pvt));
        assertEquals(0, NavPvt.VALID.get(pvt));
    }

    @Test
    public void theVersionIsThatOfARealOne() {
        byte[] version = poll(UbxMessage.MON_VER);
        assertEquals(250, version.length);
        byte[] whole = new UbxFrame(UbxMessage.MON_VER, version).toBytes();
        assertEquals("48 BC", Bytes.hex(new byte[] {whole[256], whole[257]}));
        assertTrue(new String(version, StandardCharsets.US_ASCII).startsWith("EXT CORE 3.01 (107900)\0"));
    }

    @Test
    public void settingsAreAcknowledgedOrRefused() {
        assertEquals(UBX.get("message rate acknowledged"), ask(PVT_ON));
        assertEquals(UBX.get("navigation rate acknowledged"), ask(UBX.get("five solutions a second")));
        assertEquals(UBX.get("port settings acknowledged"), ask(UBX.get("UBX, NMEA and RTCM both ways, 9600 baud")));
        assertEquals(UBX.get("key and value refused"),
            ask(UBX.get("key and value, which a generation 8 does not know")));
        String refused = UBX.get("message rate refused");
        assertEquals("an unknown message", refused, ask(frame(UbxMessage.CFG_MSG, 0x01, 0x43, 1)));
        assertEquals("of a wrong length", refused, ask(frame(UbxMessage.CFG_MSG, 0x01, 0x07, 1, 1)));
        String rate = UBX.get("navigation rate refused");
        assertEquals("too fast", rate, ask(frame(UbxMessage.CFG_RATE, 50, 0, 1, 0, 1, 0)));
        assertEquals("no cycles", rate, ask(frame(UbxMessage.CFG_RATE, 0xC8, 0, 0, 0, 1, 0)));
        assertEquals("an unknown clock", rate, ask(frame(UbxMessage.CFG_RATE, 0xC8, 0, 1, 0, 7, 0)));
        assertEquals("UART 2", UBX.get("port settings refused"), ask(frame(UbxMessage.CFG_PRT, 2)));
        assertEquals("a wrong check sum", "",
            ask(UBX.get("position, velocity and time with each solution, its checksum wrong")));
        assertEquals("a message of another class", "", ask(UBX.get("ask for the unique number")));
    }

    @Test
    public void settingQueriesReturnTheSettings() {
        assertEquals(UBX.get("UBX, NMEA and RTCM in, UBX and NMEA out, 9600 baud", "port settings acknowledged"),
            ask(UBX.get("ask for the settings of this port")));
        ask(PVT_ON);
        assertEquals(frame(UbxMessage.CFG_MSG, 1, 7, 0, 1, 0, 0, 0, 0) + " B5 62 05 01 02 00 06 01 0F 38",
            ask(frame(UbxMessage.CFG_MSG, 1, 7)));
        assertEquals(UBX.get("a solution each second", "navigation rate acknowledged"),
            ask(frame(UbxMessage.CFG_RATE)));
        assertEquals(28 + 10, Bytes.ints(ask(frame(UbxMessage.CFG_NMEA))).length);
    }

    @Test
    public void settingsOfDriversAreStoredAndReturned() {
        String air = UBX.get("navigation for up to 1 g in the air, the rest as a NEO-M8N is delivered, from u-center");
        String done = " B5 62 05 01 02 00 06 24 32 5B";
        assertEquals(changed(air, 8, 0) + done, ask(frame(UbxMessage.CFG_NAV5)));
        assertEquals(done.trim(), ask(changed(changed(air, 7, 0), 6, 1)));
        assertEquals("its bit of the mask was set", air + done, ask(frame(UbxMessage.CFG_NAV5)));
        assertEquals(done.trim(), ask(changed(changed(changed(air, 7, 0), 6, 4), 9, 2)));
        assertEquals("three dimensions only, the model as it was", changed(air, 9, 2) + done,
            ask(frame(UbxMessage.CFG_NAV5)));
        assertEquals("no such model", "B5 62 05 00 02 00 06 24 31 56", ask(changed(air, 8, 1)));
        assertEquals("no such mode", "B5 62 05 00 02 00 06 24 31 56", ask(changed(air, 9, 4)));
        assertEquals("refused, so kept", changed(air, 9, 2) + done, ask(frame(UbxMessage.CFG_NAV5)));
        String satellites = UBX.get("GPS and SBAS alone, as pilots of small aircraft set a NEO-M8N");
        assertEquals("B5 62 05 01 02 00 06 3E 4C 75", ask(satellites));
        assertEquals(changed(satellites, 7, 32) + " B5 62 05 01 02 00 06 3E 4C 75", ask(frame(UbxMessage.CFG_GNSS)));
        ask(frame(UbxMessage.CFG_GNSS, 0, 32, 32, 1, 6, 8, 14, 0, 1, 0, 1, 1));
        assertEquals("one system", changed(changed(satellites, 7, 32), 62, 1) + " B5 62 05 01 02 00 06 3E 4C 75",
            ask(frame(UbxMessage.CFG_GNSS)));
        assertEquals("no such system", "B5 62 05 00 02 00 06 3E 4B 70",
            ask(frame(UbxMessage.CFG_GNSS, 0, 32, 32, 1, 7, 8, 14, 0, 1, 0, 1, 1)));
        assertEquals("B5 62 05 01 02 00 06 16 24 4D", ask(frame(UbxMessage.CFG_SBAS, 0, 3, 3, 0, 0, 0, 0, 0)));
        ask(SAVE);
        gps.powerOff();
        gps.powerOn(line.now);
        assertEquals("saved", changed(air, 9, 2) + done, ask(frame(UbxMessage.CFG_NAV5)));
        ask(FORGET);
        assertEquals("as delivered", changed(air, 8, 0) + done, ask(frame(UbxMessage.CFG_NAV5)));
    }

    /** Returns a frame with one byte changed and a correct checksum. */
    private static String changed(String frame, int at, int value) {
        byte[] bytes = Bytes.bytes(frame);
        bytes[at] = (byte) value;
        return Bytes.hex(new UbxFrame(bytes[2], bytes[3], java.util.Arrays.copyOfRange(bytes, 6, bytes.length - 2))
            .toBytes());
    }

    @Test
    public void theSolutionIsInEachOfItsMessages() {
        byte[] pvt = poll(UbxMessage.NAV_PVT);
        assertEquals(471190000 / 1e7 + 0.166233166, NavPvt.LATITUDE.get(pvt) / 1e7, 1e-7);
        assertEquals(499600, NavPvt.ALTITUDE.get(pvt));
        assertEquals("above the ellipsoid", 499600 + 48179, NavPvt.HEIGHT.get(pvt), 1);
        assertEquals("2598", Long.toString(NavPvt.NORTHWARD.get(pvt)));
        assertEquals(1500, NavPvt.EASTWARD.get(pvt));
        assertEquals(-250, NavPvt.DOWNWARD.get(pvt));
        assertEquals(3000000, NavPvt.COURSE.get(pvt));
        assertEquals(2026, NavPvt.YEAR.get(pvt));
        assertEquals("Thursday noon, a second and 18 leap seconds", (4 * 24 + 12) * 3600000 + 19000,
            NavPvt.TIME_OF_WEEK.get(pvt));
        ByteBuffer llh = UbxFrame.room(28).put(poll(UbxMessage.NAV_POSLLH));
        assertEquals(NavPvt.LONGITUDE.get(pvt), llh.getInt(4));
        assertEquals(NavPvt.HEIGHT.get(pvt), llh.getInt(12));
        ByteBuffer sol = UbxFrame.room(52).put(poll(UbxMessage.NAV_SOL));
        assertEquals(2399, sol.getShort(8));
        assertEquals(3, sol.get(10));
        ByteBuffer ecef = UbxFrame.room(20).put(poll(UbxMessage.NAV_POSECEF));
        double[] place = {ecef.getInt(4) / 100.0, ecef.getInt(8) / 100.0, ecef.getInt(12) / 100.0};
        assertEquals(sol.getInt(12), ecef.getInt(4));
        assertEquals("from the Earth's axis, by the ellipsoid's formula", 4334814.037,
            Math.hypot(place[0], place[1]), 0.02);
        assertEquals("longitude", 8 + 33.91590 / 60, Math.toDegrees(Math.atan2(place[1], place[0])), 1e-7);
        ByteBuffer moving = UbxFrame.room(20).put(poll(UbxMessage.NAV_VELECEF));
        assertEquals("speed is the same in each frame", Math.hypot(3, 0.25) * 100,
            Math.hypot(Math.hypot(moving.getInt(4), moving.getInt(8)), moving.getInt(12)), 1);
        ByteBuffer ned = UbxFrame.room(36).put(poll(UbxMessage.NAV_VELNED));
        assertEquals(-25, ned.getInt(12));
        assertEquals("B5 62 01 04 12 00",
            Bytes.hex(new UbxFrame(UbxMessage.NAV_DOP, poll(UbxMessage.NAV_DOP)).toBytes()).substring(0, 17));
        ByteBuffer status = UbxFrame.room(16).put(poll(UbxMessage.NAV_STATUS));
        assertEquals(3, status.get(4));
        assertEquals(0x0D, status.get(5));
        assertEquals(1000, status.getInt(8));
        assertEquals(2399, UbxFrame.room(16).put(poll(UbxMessage.NAV_TIMEGPS)).getShort(8));
        byte[] sat = poll(UbxMessage.NAV_SAT);
        assertEquals(8 + 12 * 12, sat.length);
        assertEquals("00 15 32 48 28 00 00 00 1F 19 00 00", Bytes.hex(java.util.Arrays.copyOfRange(sat, 8, 20)));
        assertEquals(4, poll(UbxMessage.NAV_EOE).length);
        assertEquals(20, poll(UbxMessage.NAV_CLOCK).length);
    }

    @Test
    public void fiveHertzOfTheSolutionOnly() {
        for (int i = 0; i < 6; i++) {
            ask(frame(UbxMessage.CFG_MSG, 0xF0, i, 0));
        }
        ask(UBX.get("five solutions a second"));
        ask(PVT_ON);
        line.take();
        line.pass(4);
        List<UbxFrame> found = frames();
        assertEquals(20, found.size(), 1);
        assertTrue(found.stream().allMatch(each -> each.getMessage() == UbxMessage.NAV_PVT));
        assertEquals(200, NavPvt.TIME_OF_WEEK.get(found.get(1).getPayload()) - NavPvt.TIME_OF_WEEK.get(
            found.get(0).getPayload()));
    }

    @Test
    public void theSpeedOfTheLineChangesAfterTheAcknowledgement() {
        assertEquals(UBX.get("port settings acknowledged"), ask(port(115200)));
        assertEquals(9600, gps.getBaud());
        line.pass(0.02);
        assertEquals(115200, gps.getBaud());
        line.take();
        line.pass(2);
        assertEquals("no sentences any more", "", line.takeText());
        assertEquals("a speed that there is not", UBX.get("port settings refused"), ask(port(115201)));
    }

    /** Returns the frame that sets the port to UBX only and this speed. */
    private static String port(int baud) {
        ByteBuffer payload = UbxFrame.room(20).put(0, (byte) 1).putInt(4, 0x8D0).putInt(8, baud);
        return Bytes.hex(new UbxFrame(UbxMessage.CFG_PRT, payload.putShort(12, (short) 1).putShort(14, (short) 1)
            .array()).toBytes());
    }

    @Test
    public void theSameCommandsGiveTheSameBytes() {
        StringBuilder[] runs = {new StringBuilder(), new StringBuilder()};
        for (StringBuilder run : runs) {
            power(2);
            run.append(ask(PVT_ON)).append(ask(UBX.get("five solutions a second")))
                .append(ask(frame(UbxMessage.CFG_MSG, 1, 0x35, 2)));
            line.pass(5);
            run.append(line.takeHex());
        }
        assertTrue(runs[0].length() > 5000);
        assertEquals(runs[0].toString(), runs[1].toString());
    }

    @Test
    public void savedSettingsSurvivePowerOff() {
        ask(UBX.get("five solutions a second"));
        gps.powerOff();
        gps.powerOn(line.now);
        assertTrue("not saved", gps.status().contains("every 1000 ms"));
        ask(UBX.get("five solutions a second"));
        assertEquals(UBX.get("save acknowledged"), ask(SAVE));
        gps.powerOff();
        gps.powerOn(line.now);
        assertTrue(gps.status(), gps.status().contains("every 200 ms"));
        ask(FORGET);
        assertTrue("as delivered", gps.status().contains("every 1000 ms"));
    }

    @Test
    public void aColdStartForgetsTheSkyAndAStopStopsIt() {
        power(3);
        line.pass(4);
        assertTrue(line.takeText().contains("GNRMC,120004.00,A"));
        assertTrue("greets", new String(Bytes.bytes(ask(frame(UbxMessage.CFG_RST, 0xFF, 0xFF, 1, 0))),
            StandardCharsets.US_ASCII).contains("GNTXT"));
        line.pass(2);
        assertTrue(line.takeText().contains("GNRMC,,V"));
        line.pass(3);
        assertTrue(line.takeText().contains(",A,4717.11399"));
        ask(frame(UbxMessage.CFG_RST, 0, 0, 8, 0));
        line.pass(1.5);
        assertFalse(line.takeText().contains(",A,4717"));
        ask(frame(UbxMessage.CFG_RST, 0, 0, 9, 0));
        line.pass(1.5);
        assertTrue(line.takeText().contains(",A,4717"));
    }
}
