package org.myrobotlab.service.gps;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.Fuzz;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.nmea.SentenceReader;
import org.junit.Test;

/** Positions of real receivers are read, whatever their fields contain. */
public class GgaFixTest {
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
                    new GgaFix(sentence);
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
        GgaFix fix = new GgaFix("$GPGGA,120000.000,3336.6000,N,08051.8999,W,1,8,1.0,182.5,M,-33.0,M,,*00");
        assertEquals(15, fix.tokens.length);
        assertEquals("3336.6000", fix.tokens[2]);
        assertEquals("-08051.8999", fix.tokens[4]);
        assertEquals("182.5", fix.tokens[9]);
        assertEquals(33.61, fix.latitude, 1e-9);
        assertEquals(-80.864998, fix.longitude, 1e-6);
        assertEquals(182.5, fix.altitude, 0);
        assertEquals("-3336.6000", new GgaFix("$GPGGA,1,3336.6000,S,08051.8999,E,1,8,1.0,182.5,M,-33.0,M,,*00").tokens[2]);
    }

    @Test
    public void withoutAFixThereIsNoPosition() {
        assertFalse(new GgaFix(NO_FIX).hasFix());
        assertTrue(new GgaFix(GGA).hasFix());
        assertEquals(52.21636892, new GgaFix(GGA).latitude, 1e-8);
    }
}
