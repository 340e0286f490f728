// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.IntPredicate;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.Golden;
import org.junit.Test;

/** Finds whole telegrams in any stream of bytes. */
public class TelegramReaderTest {
    private static final Golden LMS = Golden.of("lms200");
    private static final String MODE_REPLY = LMS.get("mode changed");
    private static final String VARIANT_REPLY = LMS.get("100 degrees, each: done");

    private final List<Telegram> telegrams = new ArrayList<>();
    private final List<byte[]> wrong = new ArrayList<>();
    private final StringBuilder strays = new StringBuilder();
    private final TelegramReader reader = reader(address -> address >= Telegram.FROM_DEVICE, false);

    private TelegramReader reader(IntPredicate addresses, boolean clearing) {
        TelegramReader[] made = new TelegramReader[1];
        made[0] = new TelegramReader(addresses, new TelegramReader.Listener() {
            @Override
            public void onTelegram(Telegram telegram) {
                telegrams.add(telegram);
                startOver();
            }

            @Override
            public void onStray(int value) {
                strays.append(value == Telegram.ACK ? "A" : value == Telegram.NAK ? "N" : "-");
                startOver();
            }

            @Override
            public void onWrongChecksum(byte[] bytes) {
                wrong.add(bytes);
                startOver();
            }

            private void startOver() {
                if (clearing) {
                    made[0].clear();
                }
            }
        });
        return made[0];
    }

    private static byte[] payload(Telegram telegram) {
        return telegram.copy(0, telegram.size());
    }

    private void feed(String hex) {
        reader.accept(Bytes.bytes(hex));
    }

    @Test
    public void anAcknowledgedAnswerIsFound() {
        feed("06 " + MODE_REPLY);
        assertEquals("A", strays.toString());
        assertArrayEquals(Bytes.bytes("A0 00 10"), payload(telegrams.get(0)));
    }

    @Test
    public void anAnswerInSingleBytesIsFound() {
        for (byte b : Bytes.bytes("15 06 " + VARIANT_REPLY)) {
            reader.accept(b);
        }
        assertEquals("NA", strays.toString());
        assertEquals(1, telegrams.size());
    }

    @Test
    public void aDamagedTelegramIsLeftOutAndTheNextOneFound() {
        feed("02 80 03 00 A0 00 11 16 0A " + MODE_REPLY);
        assertEquals(1, telegrams.size());
        assertArrayEquals(Bytes.bytes("A0 00 10"), payload(telegrams.get(0)));
        assertEquals(1, wrong.size());
        assertArrayEquals(Bytes.bytes("02 80 03 00 A0 00 11 16 0A"), wrong.get(0));
    }

    @Test
    public void aTelegramThatLostBytesSwallowsNothingAfterIt() {
        feed("02 80 07 00 BB 01 64 " + MODE_REPLY + " " + VARIANT_REPLY);
        assertEquals(2, telegrams.size());
    }

    @Test
    public void theHostsOwnTelegramsAreNotAnswers() {
        feed(LMS.get("ask for a scan"));
        assertEquals(0, telegrams.size());
    }

    @Test
    public void afterGarbageTheNextTelegramIsFound() {
        Random random = new Random(Fuzz.SEED);
        for (int round = 0; round < 200; round++) {
            byte[] garbage = new byte[random.nextInt(3000)];
            random.nextBytes(garbage);
            reader.accept(garbage);
            reader.clear();
            telegrams.clear();
            feed(MODE_REPLY);
            assertEquals("seed " + Fuzz.SEED + " round " + round, 1, telegrams.size());
        }
    }

    @Test
    public void garbageDoesNotFillTheBuffer() {
        Random random = new Random(Fuzz.SEED);
        byte[] chunk = new byte[1000];
        for (int i = 0; i < 1000; i++) {
            random.nextBytes(chunk);
            reader.accept(chunk);
        }
        feed(String.join(" ", java.util.Collections.nCopies(200, MODE_REPLY)));
        assertTrue("seed " + Fuzz.SEED,
            Arrays.equals(Bytes.bytes("A0 00 10"), payload(telegrams.get(telegrams.size() - 1))));
    }

    @Test
    public void listenersMayResetTheReader() {
        TelegramReader clearing = reader(address -> address >= Telegram.FROM_DEVICE, true);
        clearing.accept(Bytes.bytes("06 " + MODE_REPLY + " 15 02 80 03 00 A0 00 11 16 0A " + VARIANT_REPLY));
        assertEquals("AN", strays.toString());
        assertEquals(1, wrong.size());
        assertEquals(2, telegrams.size());
    }

    @Test
    public void aDamagedTelegramIsReportedOnce() {
        TelegramReader any = reader(address -> true, false);
        any.accept(Bytes.bytes("02 00 06 00 02 00 01 00 31 15 13 13 " + "02 00 01 00 31 15 12"));
        assertEquals("the outer one", 1, wrong.size());
        assertEquals(1, telegrams.size());
    }

    @Test
    public void telegramsInsideAnInterruptedOneAreFound() {
        TelegramReader any = reader(address -> true, false);
        any.accept(Bytes.bytes("02 02 00 03 02 00 01 00 32 16 12"));
        assertTrue(any.isPending());
        assertEquals(0, telegrams.size());
        any.interrupt();
        assertFalse(any.isPending());
        assertEquals(LmsCommand.ERRORS.getCode(), telegrams.get(0).getCommand());
    }

    @Test
    public void theChecksumIsThatOfTheListing() {
        assertEquals(0x1215, Telegram.crc(Bytes.bytes("02 00 01 00 31"), 0, 5));
    }
}
