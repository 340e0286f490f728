// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.SEAR.Fuzz;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.nmea.SentenceReader;
import org.junit.Test;

/** Positions of real receivers are read, whatever their fields contain. */
public class FixTest {
    private static final String GGA = "$GPGGA,081436.000,5212.982135,N,00653.101394,E,1,3,2.88,102.907,M,47.093,M,,*5F";
    private static final String NO_FIX = "$GPGGA,235946.005,8960.000000,N,00000.000000,E,0,0,,137.000,M,13.000,M,,*49";

    private final List<String> found = new ArrayList<>();
    private final SentenceReader reader = new SentenceReader(found::add);

    private void feed(String text) {
        reader.feed(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** Whole sentences with a correct checksum and random fields, among random bytes. */
    @Test
    public void noSentenceStopsTheReader() {
        Random random = new Random(Fuzz.SEED);
        String letters = "0123456789.,,,,,,-NSEWMA$*\u00e4 ";
        byte[] garbage = new byte[200];
        for (int done = 0; done < Fuzz.BYTES;) {
            StringBuilder body = new StringBuilder("GPGGA,");
            for (int i = random.nextInt(90); i > 0; i--) {
                body.append(letters.charAt(random.nextInt(letters.length())));
            }
            random.nextBytes(garbage);
            reader.feed(garbage);
            feed("\r\n" + Nmea.sentence(body.toString().replaceAll("[$*\u00e4]", "")));
            done += garbage.length + body.length();
            for (String sentence : found) {
                try {
                    FixSentences.read(sentence);
                } catch (IllegalArgumentException e) {
                    assertTrue("seed " + Fuzz.SEED + ": " + e, e.getMessage() != null);
                }
            }
            found.clear();
        }
        feed("\r\n" + GGA + "\r\n");
        assertEquals("seed " + Fuzz.SEED, "[" + GGA + "]", found.toString());
    }

    @Test
    public void tokensCarryTheSignsOfSouthAndWest() {
        Fix fix = FixSentences.read("$GPGGA,120000.000,3336.6000,N,08051.8999,W,1,8,1.0,182.5,M,-33.0,M,,*00");
        assertEquals(15, fix.tokens.length);
        assertEquals("3336.6000", fix.tokens[2]);
        assertEquals("-08051.8999", fix.tokens[4]);
        assertEquals("182.5", fix.tokens[9]);
        assertEquals(33.61, fix.latitude, 1e-9);
        assertEquals(-80.864998, fix.longitude, 1e-6);
        assertEquals(182.5, fix.altitude, 0);
        assertEquals("-3336.6000", FixSentences.read(
            "$GPGGA,1,3336.6000,S,08051.8999,E,1,8,1.0,182.5,M,-33.0,M,,*00").tokens[2]);
    }

    @Test
    public void itsTextHasWhatTheReceiverReported() {
        assertEquals("fix at 33.610000, -80.864998 degrees, 182.5 m, quality 1, 8 satellites, UTC 120000.000",
            FixSentences.read("$GPGGA,120000.000,3336.6000,N,08051.8999,W,1,8,1.0,182.5,M,-33.0,M,,*00").toString());
        assertEquals("fix at 33.610000, 80.864998 degrees, quality 1",
            FixSentences.read("$GPGGA,,3336.6000,N,08051.8999,E,1,,,,M,,M,,*00").toString());
        assertEquals("no fix, 0 satellites, UTC 235946.005", FixSentences.read(NO_FIX).toString());
    }

    @Test
    public void withoutAFixThereIsNoPosition() {
        Fix none = FixSentences.read(NO_FIX);
        assertFalse(none.hasFix());
        assertNull(none.latitude);
        assertNull(none.longitude);
        assertNull(none.altitude);
        assertEquals("235946.005", none.utc);
        assertTrue(FixSentences.read(GGA).hasFix());
        assertEquals(52.21636892, FixSentences.read(GGA).latitude, 1e-8);
    }

    /** Reads a sentence's body. */
    private static Fix read(String body) {
        return FixSentences.read(Nmea.sentence(body).trim());
    }

    private static void assertPosition(double latitude, double longitude, Double altitude, int quality, Fix fix) {
        assertEquals(latitude, fix.latitude, 1e-9);
        assertEquals(longitude, fix.longitude, 1e-9);
        assertEquals(altitude, fix.altitude);
        assertEquals(quality, fix.quality);
    }

    /** Marine receivers leave out the last fields, and the altitude on the water. */
    @Test
    public void fieldsOfGgaMayBeMissing() {
        Fix marine = read("IIGGA,071500,3336.6,N,08051.9,W,1,7,1.4,,M,,M,");
        assertPosition(33.61, -80.865, null, 1, marine);
        assertEquals("", marine.tokens[9]);
        assertEquals(7, marine.satellites.intValue());
        assertPosition(33.61, -80.865, null, 2, read("GPGGA,071500,3336.6,N,08051.9,W,2,,1.4,,M,,M"));
        assertNull(read("GPGGA,071500,3336.6,N,08051.9,W,2,,1.4,,M,,M").satellites);
        assertEquals("GGA has 12 fields, legal: 13 or more",
            assertThrows(IllegalArgumentException.class, () -> read("GPGGA,071500,3336.6,N,08051.9,W,2,7,1.4,,M,"))
                .getMessage());
    }

    @Test
    public void aQualityWithoutCoordinatesIsNoFix() {
        assertFalse(read("GPGGA,071500,,,,,1,7,1.4,20.5,M,,M,,").hasFix());
        assertFalse("no quality", read("GPGGA,071500,3336.6,N,08051.9,W,,7,1.4,20.5,M,,M,,").hasFix());
        assertFalse("time only", read("GNGGA,071500.00,,,,,0,00,99.99,,,,,,").hasFix());
        assertNull("nothing", read("GNGGA,,,,,,0,,,,,,,,").utc);
    }

    @Test
    public void allTalkersAreRead() {
        for (String talker : new String[] {"GP", "GN", "GL", "GA", "GB", "BD", "QZ", "GI", "II", "IN"}) {
            assertPosition(-8.5, 115.25, 12.5, 1,
                read(talker + "GGA,235959.99,0830.0000,S,11515.0000,E,1,05,2.0,12.5,M,,M,,"));
        }
        assertNull("proprietary", read("PXGGA,235959.99,0830.0000,S,11515.0000,E,1,05,2.0,12.5,M,,M,,"));
    }

    @Test
    public void rmcAndGllHaveAPositionWithoutAltitude() {
        Fix fix = read("GPRMC,101010.50,A,0830.0000,S,11515.0000,W,0.4,270.0,010226,,,D");
        assertPosition(-8.5, -115.25, null, 2, fix);
        assertEquals("101010.50", fix.utc);
        assertNull(fix.satellites);
        assertEquals("[$GPRMC, 101010.50, -0830.0000, S, -11515.0000, W, 2, , , , M, , M, , ]",
            Arrays.toString(fix.tokens));
        assertPosition(8.5, 115.25, null, 1, read("GPRMC,101010,A,0830.0,N,11515.0,E,,"));
        assertFalse("warning", read("GPRMC,101010,V,0830.0,N,11515.0,E,,,010226,,,N").hasFix());
        assertFalse("mode N", read("GPRMC,101010,A,0830.0,N,11515.0,E,,,010226,,,N").hasFix());
        assertPosition(8.5, 115.25, null, 6, read("GLGLL,0830.0,N,11515.0,E,101010,A,E"));
        assertPosition(8.5, 115.25, null, 1, read("LCGLL,0830.0,N,11515.0,E,,A"));
        assertFalse(read("GPGLL,,,,,,V,N").hasFix());
    }

    /** Each constellation has a mode; any of them may have the fix. */
    @Test
    public void gnsHasModesOfSeveralConstellations() {
        assertPosition(8.5, 115.25, 30.25, 1, read("GNGNS,101010,0830.0,N,11515.0,E,AA,14,0.8,30.25,5.5,,"));
        assertPosition(8.5, 115.25, null, 4, read("GNGNS,101010,0830.0,N,11515.0,E,NRN,14,0.8,,,1.0,7,S"));
        assertFalse(read("GNGNS,101010,0830.0,N,11515.0,E,NN,14,0.8,30.25,5.5,,").hasFix());
        assertFalse("unsafe", read("GNGNS,101010,0830.0,N,11515.0,E,A,14,0.8,30.25,5.5,,,U").hasFix());
    }

    @Test
    public void impossibleCoordinatesAreNamed() {
        assertEquals("coordinate \"9130.0\" is 91.5 degrees, legal: 0 to 90.0",
            assertThrows(IllegalArgumentException.class, () -> read("GPGLL,9130.0,N,11515.0,E,101010,A")).getMessage());
        assertThrows(IllegalArgumentException.class, () -> read("GPGLL,0830.0,N,18100.0,E,101010,A"));
        assertThrows(IllegalArgumentException.class, () -> read("GPGLL,0830.0,N,east,E,101010,A"));
    }
}
