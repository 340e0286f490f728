// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.Bytes;
import org.junit.Test;

/** Telegrams of a real LMS200 are read whole, decoded correctly and encoded again with the same bytes. */
public class RealFramesTest {
    private static final int STATUS_BYTE = 1;

    @Test
    public void eachIsReadAndWrittenAgainByteForByte() throws IOException {
        List<byte[]> frames = RealFrames.frames();
        assertTrue(frames.size() >= 15);
        List<Telegram> found = new ArrayList<>();
        TelegramReader reader = new TelegramReader(address -> address >= Telegram.FROM_DEVICE, found::add);
        frames.forEach(reader::accept);
        assertEquals(frames.size(), found.size());
        for (int i = 0; i < frames.size(); i++) {
            assertTrue(found.get(i).isFromDevice());
            assertArrayEquals(frames.get(i), found.get(i).toBytes());
        }
    }

    @Test
    public void scansAre361ValuesInMillimetres() throws IOException {
        for (Telegram scan : RealFrames.telegrams(LmsCommand.SCAN.getReply())) {
            CountWord count = CountWord.of(scan.wordAt(1));
            assertEquals(361, count.getCount());
            assertEquals(1, count.getUnit());
            assertEquals(CountWord.whole(361, 1).toWord(), count.toWord());
            assertEquals("command, count, values, status", 3 + 2 * 361 + STATUS_BYTE, scan.size());
            assertEquals(StatusByte.OK, scan.last());
        }
    }

    @Test
    public void theStatusIsReadAtItsOffsets() throws IOException {
        List<Telegram> found = RealFrames.telegrams(LmsCommand.STATUS.getReply());
        assertEquals(4, found.size());
        for (Telegram telegram : found) {
            LmsStatus status = LmsStatus.of(telegram);
            assertEquals(LmsStatus.SIZE, telegram.size());
            assertEquals(180, status.getSpread());
            assertEquals(50, status.getResolution());
            assertEquals(Baud.B38400.getStatusWord(), status.getBaudWord());
            assertEquals(1, status.getUnit());
        }
        assertEquals(OperatingMode.ON_REQUEST, LmsStatus.of(found.get(0)).getMode());
        assertEquals(OperatingMode.INSTALLATION, LmsStatus.of(found.get(1)).getMode());
    }

    @Test
    public void aSimulatedStatusEqualsTheRealOne() throws IOException {
        Telegram real = RealFrames.telegrams(LmsCommand.STATUS.getReply()).get(0);
        Configuration configuration = Configuration.of(RealFrames.telegrams(LmsCommand.GET_CONFIGURATION.getReply())
            .get(0), 1);
        byte[] made = LmsStatus.encode(new Identity("LMS200;S18063;V02.19 ", "05270497", 0), OperatingMode.ON_REQUEST,
            Variant.V180_HALF, configuration, Baud.B38400, false, StatusByte.OK);
        assertEquals(Bytes.hex(real.toBytes()), Bytes.hex(new Telegram(Telegram.FROM_DEVICE, made).toBytes()));
    }

    @Test
    public void theConfigurationIsOfSixteenMetres() throws IOException {
        for (Telegram telegram : RealFrames.telegrams(LmsCommand.SET_CONFIGURATION.getReply())) {
            assertEquals(1, telegram.at(1));
            assertEquals(MeasuringMode.FIELDS_16_A_B, Configuration.of(telegram, 2).getMode());
        }
    }
}
