package org.myrobotlab.service.lidar;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/** Telegrams are found in any stream of bytes, whole ones only. */
public class LmsFramerTest {
    private static final String MODE_REPLY = "02 80 03 00 A0 00 10 16 0A";
    private static final String VARIANT_REPLY = "02 80 07 00 BB 01 64 00 64 00 10 4F BD";

    private final List<byte[]> telegrams = new ArrayList<>();
    private final StringBuilder signs = new StringBuilder();
    private final LmsFramer framer = new LmsFramer();
    private final LmsFramer.Sink sink = new LmsFramer.Sink() {
        @Override
        public void acknowledged() {
            signs.append('A');
        }

        @Override
        public void refused() {
            signs.append('N');
        }

        @Override
        public void telegram(byte[] body) {
            telegrams.add(body);
        }
    };

    private void feed(String hex) {
        framer.feed(Hex.bytes(hex), sink);
    }

    @Test
    public void anAcknowledgedAnswerIsFound() {
        feed("06 " + MODE_REPLY);
        assertEquals("A", signs.toString());
        assertArrayEquals(Hex.bytes("A0 00 10"), telegrams.get(0));
    }

    @Test
    public void anAnswerInSingleBytesIsFound() {
        for (byte b : Hex.bytes("15 06 " + VARIANT_REPLY)) {
            framer.feed(new byte[] {b}, sink);
        }
        assertEquals("NA", signs.toString());
        assertEquals(1, telegrams.size());
    }

    @Test
    public void aDamagedTelegramIsLeftOutAndTheNextOneFound() {
        feed("02 80 03 00 A0 00 11 16 0A " + MODE_REPLY);
        assertEquals(1, telegrams.size());
        assertArrayEquals(Hex.bytes("A0 00 10"), telegrams.get(0));
        assertTrue(framer.getDropped() > 0);
    }

    @Test
    public void aTelegramThatLostBytesSwallowsNothingAfterIt() {
        feed("02 80 07 00 BB 01 64 " + MODE_REPLY + " " + VARIANT_REPLY);
        assertEquals(2, telegrams.size());
    }

    @Test
    public void theHostsOwnTelegramsAreNoAnswers() {
        feed("02 00 02 00 30 01 31 18");
        assertEquals(0, telegrams.size());
    }

    @Test
    public void afterGarbageTheNextTelegramIsFound() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        for (int round = 0; round < 200; round++) {
            byte[] garbage = new byte[random.nextInt(3000)];
            random.nextBytes(garbage);
            framer.feed(garbage, sink);
            framer.reset();
            telegrams.clear();
            feed(MODE_REPLY);
            assertEquals("seed " + seed + " round " + round, 1, telegrams.size());
        }
    }

    @Test
    public void garbageAloneNeverFillsTheBufferForEver() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        byte[] chunk = new byte[1000];
        for (int i = 0; i < 1000; i++) {
            random.nextBytes(chunk);
            framer.feed(chunk, sink);
        }
        feed(String.join(" ", java.util.Collections.nCopies(200, MODE_REPLY)));
        assertTrue("seed " + seed, Arrays.equals(Hex.bytes("A0 00 10"), telegrams.get(telegrams.size() - 1)));
    }

    @Test
    public void aTelegramMayMakeItsTakerStartOver() {
        LmsFramer.Sink resetting = new LmsFramer.Sink() {
            @Override
            public void acknowledged() {
                framer.reset();
            }

            @Override
            public void refused() {
                framer.reset();
            }

            @Override
            public void telegram(byte[] body) {
                telegrams.add(body);
                framer.reset();
            }
        };
        framer.feed(Hex.bytes("06 " + MODE_REPLY + " 15 " + VARIANT_REPLY), resetting);
        assertEquals(2, telegrams.size());
    }

    @Test
    public void requestsAreFramedAsTheListingPrintsThem() {
        assertEquals("02 00 02 00 30 01 31 18", Hex.text(LmsTelegram.frame(LmsTelegram.of(LmsTelegram.SCAN, 1))));
        assertEquals("02 00 01 00 31 15 12", Hex.text(LmsTelegram.frame(LmsTelegram.of(LmsTelegram.STATUS))));
        assertEquals("02 00 05 00 3B 64 00 64 00 1D 0F", Hex.text(LmsTelegram.frame(LmsTelegram.variant(100, 100))));
        assertEquals("02 00 05 00 3B 64 00 32 00 B1 59", Hex.text(LmsTelegram.frame(LmsTelegram.variant(100, 50))));
        assertEquals("02 00 05 00 3B 64 00 19 00 E7 72", Hex.text(LmsTelegram.frame(LmsTelegram.variant(100, 25))));
        assertEquals("02 00 05 00 3B B4 00 64 00 97 49", Hex.text(LmsTelegram.frame(LmsTelegram.variant(180, 100))));
        assertEquals("02 00 05 00 3B B4 00 32 00 3B 1F", Hex.text(LmsTelegram.frame(LmsTelegram.variant(180, 50))));
        assertEquals("02 00 02 00 20 42 52 08", Hex.text(LmsTelegram.frame(LmsTelegram.of(LmsTelegram.MODE, LmsDriver.BAUDS[0][1]))));
        assertEquals("02 00 02 00 20 41 51 08", Hex.text(LmsTelegram.frame(LmsTelegram.of(LmsTelegram.MODE, LmsDriver.BAUDS[1][1]))));
        assertEquals("02 00 02 00 20 40 50 08", Hex.text(LmsTelegram.frame(LmsTelegram.of(LmsTelegram.MODE, LmsDriver.BAUDS[2][1]))));
        assertEquals("02 00 02 00 20 48 58 08", Hex.text(LmsTelegram.frame(LmsTelegram.of(LmsTelegram.MODE, LmsDriver.BAUDS[3][1]))));
        assertEquals("02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5", Hex.text(LmsTelegram.frame(LmsTelegram.installationMode())));
        assertEquals("02 00 01 00 74 50 12", Hex.text(LmsTelegram.frame(LmsTelegram.of(LmsTelegram.GET_CONFIGURATION))));
    }
}
