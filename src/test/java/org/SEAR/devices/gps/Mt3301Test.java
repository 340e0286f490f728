// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.time.Instant;
import org.SEAR.Golden;
import org.SEAR.devices.FakeContext;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.sensors.GpsFix;
import org.junit.Before;
import org.junit.Test;

/** The receiver compared with recordings of real ones. */
public class Mt3301Test {
    private static final Golden NMEA = Golden.of("nmea");
    private static final String[] COMMANDS = NMEA.each("test", "hot start", "warm start", "cold start",
        "full cold start", "a fix each second",
        "2 fixes a second", "4 fixes a second", "5 fixes a second", "10 fixes a second", "baud rate of its start",
        "4800 baud", "9600 baud",
        "14400 baud", "19200 baud", "38400 baud", "57600 baud", "115200 baud", "an interval of a second between fixes",
        "an interval of 200 ms between fixes", "corrections by satellites", "look for satellites of corrections",
        "GGA only", "RMC and GGA only",
        "all sentences, GSV with each fifth fix", "sentences of its start", "no power saving",
        "ask for the interval between fixes",
        "ask for the source of corrections", "ask whether it looks for corrections", "ask which sentences",
            "ask for the release");

    private FakeContext line;
    private Mt3301 gps;

    @Before
    public void power() {
        power(GpsModel.MT3301, 0);
    }

    private void power(GpsModel model, double timeToFix) {
        line = new FakeContext();
        line.reading = new GpsFix(33.61, -80.865, 182.5, 0, 0, FakeContext.EPOCH);
        gps = line.attach(new Mt3301(model, 38400, 1, timeToFix, line));
        line.pass(0.5);
        line.take();
    }

    private String ask(String command) {
        line.take();
        line.hostText(command + "\r\n");
        return line.takeText().trim();
    }

    private static long millis(String utc) {
        return Instant.parse(utc).toEpochMilli();
    }

    private static GpsFix recorded() {
        return new GpsFix(52 + 12.982135 / 60, 6 + 53.101394 / 60, 102.907, 0.039 * 1852 / 3600, 0, 0);
    }

    @Test
    public void sentencesAsRecorded() {
        Sentences real = new Sentences(SentenceStyle.MT3301, recorded(), millis("2008-08-23T08:14:36Z"));
        assertEquals(NMEA.get("place with three satellites, recorded") + "\r\n",
            Nmea.sentence(real.gga(3, "2.88", 47.093)));
        assertEquals(NMEA.get("the least that one needs, recorded") + "\r\n", Nmea.sentence(real.rmc()));
        assertEquals(NMEA.get("course and speed, recorded") + "\r\n", Nmea.sentence(real.vtg()));
        Sentences none = new Sentences(SentenceStyle.MT3301, null, millis("2008-08-22T23:59:46.005Z"));
        assertEquals(NMEA.get("place without a fix, recorded") + "\r\n", Nmea.sentence(none.gga()));
        GpsFix other = new GpsFix(51 + 29.0623 / 60, 6 + 32.2910 / 60, 29.7, 0, 0, 0);
        Sentences mt3329 = new Sentences(SentenceStyle.MT3329, other, millis("2010-01-01T10:21:28Z"));
        assertEquals(NMEA.get("place by an MT3329, recorded") + "\r\n", Nmea.sentence(mt3329.gga(4, "1.31", 47.4)));
        assertEquals(NMEA.get("it has restarted") + "\r\n", Nmea.sentence("PMTK010,001"));
    }

    /** The sentences of each fix leave after the latency and keep the time of the fix. */
    @Test
    public void aFixIsSentAfterItsLatency() {
        gps.withLatency(0.15);
        line.pass(2.7);
        assertEquals(1.15, line.messages.get(0), 1e-9);
        assertEquals(2.15, line.messages.get(1), 1e-9);
        assertTrue(line.takeText().startsWith("$GPGGA,120001.000"));
    }

    @Test
    public void checksumsBothWays() {
        for (String command : COMMANDS) {
            String body = Nmea.body(command);
            assertEquals(command + "\r\n", Nmea.sentence(body));
        }
        assertNull(Nmea.body(NMEA.get("a fix each second, its checksum wrong")));
        assertNull(Nmea.body("$*"));
        assertNull(Nmea.body("$PMTK220,1000"));
    }

    @Test
    public void commandsAreAcknowledged() {
        String[][] pairs = {NMEA.each("5 fixes a second", "fixes per second: done"),
            NMEA.each("9600 baud", "baud rate: done"), NMEA.each("sentences of its start", "which sentences: done"),
            NMEA.each("an interval of a second between fixes", "interval between fixes: done"),
            {Nmea.sentence("PMTK604").trim(), NMEA.get("604: done")},
            NMEA.each("ask for the interval between fixes", "the interval between fixes is a second"),
            NMEA.each("10 fixes a second", "fixes per second: failed"), {Nmea.sentence("PMTK999").trim(), ""}};
        for (String[] pair : pairs) {
            power();
            String answer = ask(pair[0]);
            if (pair[1].isEmpty()) {
                assertTrue(answer, answer.startsWith("$PMTK001,999,1*"));
            } else {
                assertEquals(pair[1], answer);
            }
        }
        power(GpsModel.MT3329, 0);
        assertEquals(NMEA.get("release AXN_1.30"), ask(NMEA.get("ask for the release")));
        assertTrue(ask(NMEA.get("hot start")).contains(NMEA.get("hot start: done")));
        for (String command : COMMANDS) {
            power();
            assertFalse(command, ask(command).isEmpty());
        }
    }

    @Test
    public void powerOnGreetsAndThenSendsEverySecond() {
        line = new FakeContext();
        line.reading = new GpsFix(33.61, -80.865, 182.5, 0, 0, 0);
        line.attach(new Mt3301(GpsModel.MT3301, 38400, 1, 0, line));
        line.pass(0.9);
        assertTrue(line.takeText().startsWith("$PMTK010,001*2E\r\n$POLYN,TIME,RESTART_OCCURRED\r\n"));
        line.pass(10);
        String text = line.takeText();
        assertEquals(10, text.split("\\$GPGGA", -1).length - 1);
        assertEquals(10, text.split("\\$GPRMC", -1).length - 1);
        assertEquals(2, text.split("\\$GPGSA", -1).length - 1);
        assertTrue(text, text.startsWith(
            "$GPGGA,120001.000,3336.600000,N,08051.900000,W,1,8,1.02,182.500,M,-32.797,M,,*"));
        for (String sentence : text.split("\r\n")) {
            assertTrue(sentence, Nmea.body(sentence) != null);
        }
    }

    @Test
    public void fiveHertzOfPositionOnly() {
        ask(NMEA.get("GGA only"));
        ask(NMEA.get("5 fixes a second"));
        line.take();
        line.pass(10);
        assertEquals(50, line.takeText().split("\r\n").length, 1);
    }

    @Test
    public void allSentencesOnRequest() {
        ask(NMEA.get("all sentences, GSV with each fifth fix"));
        line.pass(1);
        String text = line.takeText();
        for (String kind : new String[] {"GGA", "GLL", "RMC", "VTG", "GSA", "GSV", "ZDA"}) {
            assertTrue(kind, text.contains("$GP" + kind));
        }
        assertTrue(text, text.contains("$GPZDA,120001.000,01,01,2026,00,00*"));
        assertTrue(text, text.contains("$GPGLL,3336.600000,N,08051.900000,W,120001.000,A,A*"));
    }

    @Test
    public void noFixAtFirstIfConfiguredAndWhenTheSensorLosesIt() {
        power(GpsModel.MT3301, 3);
        line.pass(2);
        assertTrue(line.takeText().contains(",8960.000000,N,00000.000000,E,0,0,,"));
        line.pass(2);
        assertTrue(line.takeText().contains(",3336.600000,N,"));
        line.reading = GpsFix.none(0);
        line.pass(1);
        assertTrue(line.takeText().contains("$GPRMC,120005.000,V,"));
    }

    @Test
    public void theYearRollsOver() {
        line.epoch = millis("2027-12-31T23:59:58Z");
        line.pass(2);
        String text = line.takeText();
        assertTrue(text, text.contains("$GPRMC,235959.000,A") && text.contains(",311227,"));
        assertTrue(text, text.contains("$GPRMC,000000.000,A") && text.contains(",010128,"));
    }

    @Test
    public void minutesNeverShowSixty() {
        assertEquals("3400.0000", Nmea.degrees(33.99999999, 2, 4));
        assertEquals("18000.000000", Nmea.degrees(-180, 3, 6));
        assertEquals("0000.000000", Nmea.degrees(0, 2, 6));
    }

    @Test
    public void theBaudRateChangesAfterTheAcknowledgement() {
        ask(NMEA.get("4800 baud"));
        assertEquals(38400, gps.getBaud());
        line.pass(0.1);
        assertEquals(4800, gps.getBaud());
        line.hostText(Nmea.sentence("PQBAUD,W,38400"));
        line.pass(0.2);
        assertEquals(38400, gps.getBaud());
    }

    @Test
    public void aSlowLineSkipsFixesInsteadOfFallingBehind() {
        ask(NMEA.get("4800 baud"));
        line.pass(0.2);
        ask(NMEA.get("5 fixes a second"));
        line.pass(60);
        assertTrue("behind by " + (line.lineFreeAt() - line.now), line.lineFreeAt() - line.now < 1.5);
    }

    @Test
    public void thePowerSwitchRestartsAReceiver() {
        power(GpsModel.MT3301, 3);
        line.pass(4);
        ask(NMEA.get("9600 baud"));
        line.pass(1);
        ask(NMEA.get("5 fixes a second"));
        line.pass(1);
        assertEquals(9600, gps.getBaud());
        gps.powerOff();
        line.now += 100;
        line.take();
        gps.powerOn(line.now);
        assertEquals(38400, gps.getBaud());
        line.pass(2.5);
        String text = line.takeText();
        assertTrue(text, text.startsWith("$PMTK") && text.contains("RESTART_OCCURRED"));
        assertEquals("a fix a second", 2, text.split("GPGGA", -1).length - 1, 1);
        assertFalse("none yet: " + text, text.contains("GPRMC") && text.contains(",A,3336"));
        line.pass(2);
        assertTrue(line.takeText().contains(",A,3336"));
    }
}
