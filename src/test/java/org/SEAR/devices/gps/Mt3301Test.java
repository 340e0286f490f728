package org.SEAR.devices.gps;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.time.Instant;
import org.SEAR.devices.FakeContext;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.sensors.GpsFix;
import org.junit.Before;
import org.junit.Test;

/** The receiver against recordings of real ones. */
public class Mt3301Test {
    private static final String[] COMMANDS = {"$PMTK000*32", "$PMTK101*32", "$PMTK102*31", "$PMTK103*30", "$PMTK104*37", "$PMTK220,1000*1F",
        "$PMTK220,500*2B", "$PMTK220,250*29", "$PMTK220,200*2C", "$PMTK220,100*2F", "$PMTK251,0*28", "$PMTK251,4800*14", "$PMTK251,9600*17",
        "$PMTK251,14400*29", "$PMTK251,19200*22", "$PMTK251,38400*27", "$PMTK251,57600*2C", "$PMTK251,115200*1F", "$PMTK300,1000,0,0,0,0*1C",
        "$PMTK300,200,0,0,0,0*2F", "$PMTK301,2*2E", "$PMTK313,1*2E", "$PMTK314,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0*29",
        "$PMTK314,0,1,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0*28", "$PMTK314,1,1,1,1,1,5,0,0,0,0,0,0,0,0,0,0,0,1,0*2D", "$PMTK314,-1*04",
        "$PMTK320,0*2F", "$PMTK400*36", "$PMTK401*37", "$PMTK413*34", "$PMTK414*33", "$PMTK605*31"};

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
        assertEquals("$GPGGA,081436.000,5212.982135,N,00653.101394,E,1,3,2.88,102.907,M,47.093,M,,*5F\r\n",
            Nmea.sentence(real.gga(3, "2.88", 47.093)));
        assertEquals("$GPRMC,081436.000,A,5212.982135,N,00653.101394,E,0.039,0.00,230808,,,A*53\r\n", Nmea.sentence(real.rmc()));
        assertEquals("$GPVTG,0.00,T,,M,0.039,N,0.072,K,A*32\r\n", Nmea.sentence(real.vtg()));
        Sentences none = new Sentences(SentenceStyle.MT3301, null, millis("2008-08-22T23:59:46.005Z"));
        assertEquals("$GPGGA,235946.005,8960.000000,N,00000.000000,E,0,0,,137.000,M,13.000,M,,*49\r\n", Nmea.sentence(none.gga()));
        GpsFix other = new GpsFix(51 + 29.0623 / 60, 6 + 32.2910 / 60, 29.7, 0, 0, 0);
        Sentences mt3329 = new Sentences(SentenceStyle.MT3329, other, millis("2010-01-01T10:21:28Z"));
        assertEquals("$GPGGA,102128.000,5129.0623,N,00632.2910,E,1,4,1.31,29.7,M,47.4,M,,*6D\r\n", Nmea.sentence(mt3329.gga(4, "1.31", 47.4)));
        assertEquals("$PMTK010,001*2E\r\n", Nmea.sentence("PMTK010,001"));
    }

    @Test
    public void checksumsBothWays() {
        for (String command : COMMANDS) {
            String body = Nmea.body(command);
            assertEquals(command + "\r\n", Nmea.sentence(body));
        }
        assertNull(Nmea.body("$PMTK220,1000*1E"));
        assertNull(Nmea.body("$*"));
        assertNull(Nmea.body("$PMTK220,1000"));
    }

    @Test
    public void commandsAreAcknowledged() {
        String[][] pairs = {{"$PMTK220,200*2C", "$PMTK001,220,3*30"}, {"$PMTK251,9600*17", "$PMTK001,251,3*36"},
            {"$PMTK314,-1*04", "$PMTK001,314,3*36"}, {"$PMTK300,1000,0,0,0,0*1C", "$PMTK001,300,3*33"},
            {Nmea.sentence("PMTK604").trim(), "$PMTK001,604,3*32"},
            {"$PMTK400*36", "$PMTK500,1000,0,0,0,0*1A"}, {"$PMTK220,100*2F", "$PMTK001,220,2*31"},
            {Nmea.sentence("PMTK999").trim(), ""}};
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
        assertEquals("$PMTK705,AXN_1.30,0000,20090609,*20", ask("$PMTK605*31"));
        assertTrue(ask("$PMTK101*32").contains("$PMTK001,101,3*30"));
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
        assertTrue(text, text.startsWith("$GPGGA,120001.000,3336.600000,N,08051.900000,W,1,8,1.02,182.500,M,-32.797,M,,*"));
        for (String sentence : text.split("\r\n")) {
            assertTrue(sentence, Nmea.body(sentence) != null);
        }
    }

    @Test
    public void fiveHertzOfPositionOnly() {
        ask("$PMTK314,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0*29");
        ask("$PMTK220,200*2C");
        line.take();
        line.pass(10);
        assertEquals(50, line.takeText().split("\r\n").length, 1);
    }

    @Test
    public void allSentencesOnRequest() {
        ask("$PMTK314,1,1,1,1,1,5,0,0,0,0,0,0,0,0,0,0,0,1,0*2D");
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
        ask("$PMTK251,4800*14");
        assertEquals(38400, gps.getBaud());
        line.pass(0.1);
        assertEquals(4800, gps.getBaud());
        line.hostText(Nmea.sentence("PQBAUD,W,38400"));
        line.pass(0.2);
        assertEquals(38400, gps.getBaud());
    }

    @Test
    public void aSlowLineLeavesOutFixesInsteadOfFallingBehind() {
        ask("$PMTK251,4800*14");
        line.pass(0.2);
        ask("$PMTK220,200*2C");
        line.pass(60);
        assertTrue("behind by " + (line.lineFreeAt() - line.now), line.lineFreeAt() - line.now < 1.5);
    }

    @Test
    public void thePowerSwitchMakesAReceiverBeginAgain() {
        power(GpsModel.MT3301, 3);
        line.pass(4);
        ask("$PMTK251,9600*17");
        line.pass(1);
        ask("$PMTK220,200*2C");
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
