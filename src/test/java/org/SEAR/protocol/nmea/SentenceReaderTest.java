// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.nmea;

import static org.junit.Assert.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.Fuzz;
import org.junit.Test;

/** Reads sentences of real receivers and skips damaged ones. */
public class SentenceReaderTest {
    private static final String GGA = "$GPGGA,081436.000,5212.982135,N,00653.101394,E,1,3,2.88,102.907,M,47.093,M,,*5F";
    private static final String MT3329 = "$GPGGA,102128.000,5129.0623,N,00632.2910,E,1,4,1.31,29.7,M,47.4,M,,*6D";
    private static final String NO_FIX = "$GPGGA,235946.005,8960.000000,N,00000.000000,E,0,0,,137.000,M,13.000,M,,*49";

    private final List<String> found = new ArrayList<>();
    private final SentenceReader reader = new SentenceReader(found::add);

    private void feed(String text) {
        reader.feed(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    @Test
    public void aLogOfARealReceiverIsReadWhole() {
        feed("$PMTK010,001*2E\r\n$POLYN,TIME,RESTART_OCCURRED\r\n" + NO_FIX + "\r\n" + GGA + "\r\n"
            + "$GPGSA,A,2,21,28,08,,,,,,,,,,3.05,2.88,1.00*07\r\n$GPVTG,0.00,T,,M,0.039,N,0.072,K,A*32\r\n");
        assertEquals(6, found.size());
        assertEquals(0, reader.getDamaged());
    }

    @Test
    public void aWrongCheckSumIsLeftOut() {
        feed(GGA.replace("5212", "5213") + "\r\n" + MT3329 + "\r\n");
        assertEquals("[" + MT3329 + "]", found.toString());
        assertEquals(1, reader.getDamaged());
    }

    @Test
    public void aSentenceThatBreaksOffDoesNotHurtTheNext() {
        feed(GGA.substring(0, 30) + MT3329 + "\r\n");
        assertEquals("[" + MT3329 + "]", found.toString());
    }

    @Test
    public void afterGarbageTheNextSentenceIsRead() {
        Random random = new Random(Fuzz.SEED);
        byte[] garbage = new byte[1_000_000];
        random.nextBytes(garbage);
        reader.feed(garbage);
        found.clear();
        feed("\r\n" + GGA + "\r\n");
        assertEquals("seed " + Fuzz.SEED, "[" + GGA + "]", found.toString());
    }

    @Test
    public void onlyMakersOwnSentencesDoWithoutChecksum() {
        feed("$GPGGA,120000\r\n$POLYN,EPH,0,00000000\r\n");
        assertEquals("[$POLYN,EPH,0,00000000]", found.toString());
        assertEquals(1, reader.getDamaged());
    }

    @Test
    public void aSentenceThatNeverEndsIsGivenUp() {
        feed("$GP" + "A".repeat(100_000) + "\r\n" + GGA + "\r\n");
        assertEquals("[" + GGA + "]", found.toString());
        assertEquals(1, reader.getDamaged());
    }
}
