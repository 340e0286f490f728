// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.Bytes;
import org.SEAR.protocol.lms.CountWord;
import org.SEAR.protocol.lms.LmsCommand;
import org.SEAR.protocol.lms.MeasuringMode;
import org.SEAR.protocol.lms.RealFrames;
import org.SEAR.protocol.lms.StatusByte;
import org.SEAR.protocol.lms.Telegram;
import org.SEAR.protocol.lms.TelegramReader;
import org.junit.Test;

/** Scans are decoded as in the telegram listing. */
public class LmsRepliesTest {
    private static Telegram telegram(String hex) {
        List<Telegram> found = new ArrayList<>();
        new TelegramReader(address -> address >= Telegram.FROM_DEVICE, found::add).accept(Bytes.bytes(hex));
        return found.get(0);
    }

    private static RangeScan scan(String hex) {
        return LmsReplies.scan(telegram(hex), MeasuringMode.FIELDS_A_B_DAZZLE, 1, 0);
    }

    @Test
    public void flagBitsAreIgnoredAndOverflowsAreNoReturn() {
        RangeScan scan = scan("02 80 0E 00 B0 05 40 00 00 01 00 E8 83 F7 1F FF 1F 10 D4 58");
        assertArrayEquals(new int[] {0, 1, 1000, 8183, 8191}, scan.raw);
        assertEquals("mm", scan.unit);
        assertEquals(1.0, scan.metres[2], 0);
        assertNull(scan.metres[3]);
        assertNull(scan.metres[4]);
    }

    @Test
    public void centimetresAreHundredthsOfMetres() {
        RangeScan scan = scan("02 80 0A 00 B0 03 00 64 00 C8 00 2C 01 10 BE 64");
        assertArrayEquals(new int[] {100, 200, 300}, scan.raw);
        assertEquals("cm", scan.unit);
        assertEquals(3.0, scan.metres[2], 1e-12);
    }

    @Test
    public void aFieldFlagDoesNotChangeTheDistance() {
        assertArrayEquals(new int[] {1234}, scan("02 80 06 00 B0 01 40 D2 24 10 B0 99").raw);
    }

    @Test
    public void theFirstValueIsTheRightmostBeam() {
        StringBuilder hex = new StringBuilder("02 80 6E 01 B0 B5 00");
        for (int i = 0; i <= 180; i++) {
            hex.append(String.format(" %02X 00", i));
        }
        RangeScan wide = scan(hex + " 10 D5 D8");
        assertEquals(0, wide.angles[0], 0);
        assertEquals(180, wide.angles[180], 0);
        assertEquals(180, wide.raw[180]);
        String narrow = "02 80 CE 00 B0 65 00" + " FF 1F".repeat(101) + " 10 60 E9";
        assertEquals(40, scan(narrow).angles[0], 0);
        assertEquals(140, scan(narrow).angles[100], 0);
        String fine = "02 80 26 03 B0 91 01" + " FF 1F".repeat(401) + " 10 04 B1";
        assertEquals(0.25, scan(fine).resolution, 0);
    }

    @Test
    public void nothingHitIsNoReturnInEveryMode() {
        for (MeasuringMode mode : MeasuringMode.values()) {
            int nothing = mode.getNothingHit();
            Telegram telegram = new Telegram(Telegram.FROM_DEVICE,
                LmsCommand.SCAN.reply().word(CountWord.whole(2, 1).toWord()).word(nothing).word(1234).add(StatusByte.OK)
                    .toBytes());
            RangeScan scan = LmsReplies.scan(telegram, mode, 1, 0);
            assertNull(mode.name(), scan.metres[0]);
            assertEquals(1.234, scan.metres[1], 1e-12);
        }
    }

    @Test
    public void aScanOfARealDeviceIsInMetres() throws IOException {
        List<Telegram> scans = RealFrames.telegrams(LmsCommand.SCAN.getReply());
        assertTrue(scans.size() >= 2);
        RangeScan scan = LmsReplies.scan(scans.get(0), MeasuringMode.FIELDS_16_A_B, 0.5, 0);
        assertEquals(361, scan.raw.length);
        assertEquals(0.205, scan.metres[0], 1e-12);
        assertEquals(0.208, scan.metres[1], 1e-12);
        assertEquals("mm", scan.unit);
        assertEquals(1, java.util.Arrays.stream(scan.raw).filter(value -> value == 0x3FFB).count());
    }
}
