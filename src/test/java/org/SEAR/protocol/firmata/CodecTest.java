// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.firmata;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.Golden;
import org.junit.Test;

/** Messages as in protocol.md, encoder.md, PingFirmata and johnny-five. */
public class CodecTest {
    private static final Golden FIRMATA = Golden.of("firmata");
    private static List<FirmataMessage> read(int most, String hex) {
        List<FirmataMessage> found = new ArrayList<>();
        FirmataReader reader = new FirmataReader(most, found::add);
        for (int each : Bytes.ints(hex)) {
            reader.accept(each);
        }
        return found;
    }

    private static String hex(FirmataMessage message) {
        return Bytes.hex(message.toBytes());
    }

    @Test
    public void numbersHaveTheirLowSevenBitsFirst() {
        assertEquals("E3 7F 07", hex(FirmataMessage.number(FirmataMessage.ANALOG, 3, 1023)));
        assertEquals("91 20 01", hex(FirmataMessage.number(FirmataMessage.DIGITAL, 1, 0xA0)));
        FirmataMessage read = read(FirmataReader.BOARD, "E3 7F 07").get(0);
        assertEquals(FirmataMessage.ANALOG, read.getCommand());
        assertEquals(3, read.getChannel());
        assertEquals(1023, read.getNumber(0));
    }

    @Test
    public void theFirmwaresName() {
        assertEquals(FIRMATA.get("StandardFirmata.ino 2.5"),
            hex(FirmataMessage.text(Feature.FIRMWARE, new int[] {2, 5}, "StandardFirmata.ino")));
        assertEquals("Tür", read(FirmataReader.HOST, hex(FirmataMessage.text(Feature.STRING, new int[0], "Tür"))).get(0)
            .getText(0));
    }

    @Test
    public void echoesAsJohnnyFiveAsksForThem() {
        String request = FIRMATA.get("ping at pin 7: 5 us high, a second's patience");
        assertEquals(request, hex(EchoMessage.request(7, true, 5, 1000000)));
        FirmataMessage read = read(FirmataReader.BOARD, request).get(0);
        assertTrue(EchoMessage.isRequest(read));
        assertEquals(7, read.get(0));
        assertEquals(1000000, EchoMessage.timeout(read));
        assertEquals(FIRMATA.get("echo at pin 7 after 1000 us"), hex(EchoMessage.answer(7, 1000)));
        assertEquals(3000000000L, EchoMessage.duration(EchoMessage.answer(7, 3000000000L)));
        assertFalse(EchoMessage.isRequest(EchoMessage.answer(7, 1000)));
    }

    @Test
    public void positionsOfEncoders() {
        assertEquals(FIRMATA.get("encoder 2 at -300"), hex(EncoderMessage.positions(new int[] {2}, new long[] {-300})));
        assertEquals(FIRMATA.get("encoders 0 and 4 at the ends"),
            hex(EncoderMessage.positions(new int[] {0, 4}, new long[] {1, 0xFFFFFFF})));
    }

    @Test
    public void unknownMessagesAreSkipped() {
        assertEquals(0, read(FirmataReader.BOARD, "01 02 F1 05 F0 79 F9").stream()
            .filter(FirmataMessage::isSysex).count());
        List<FirmataMessage> found = read(FirmataReader.BOARD, "33 F4 0D 01 44 F0 F7 F0 79 F7 F9");
        assertEquals(3, found.size());
        assertArrayEquals(Bytes.bytes("F4 0D 01"), found.get(0).toBytes());
        assertEquals(FIRMATA.get("ask for the firmware"), hex(found.get(1)));
        assertEquals(FirmataMessage.VERSION, found.get(2).getCommand());
    }

    @Test
    public void aSysexMayBeAsLongAsTheBoardsBuffer() {
        String data = new String(new char[64]).replace("\0", "05 ");
        assertEquals(64, read(FirmataReader.BOARD, "F0 71 " + data + "F7").get(0).size());
        assertEquals(0, read(FirmataReader.BOARD, "F0 71 " + data + "05 F7").size());
        assertEquals(65, read(FirmataReader.HOST, "F0 71 " + data + "05 F7").get(0).size());
    }

    @Test
    public void aMillionRandomBytes() {
        Random random = new Random(Fuzz.SEED);
        int[] messages = new int[1];
        FirmataReader reader = new FirmataReader(FirmataReader.BOARD, message -> {
            messages[0]++;
            assertTrue(message.size() <= FirmataReader.BOARD);
        });
        int[] likely = Bytes.ints("F0 F7 79 75 61 6B F4 E0 90 C0 D0 00 01 FF F9");
        for (int i = 0; i < Fuzz.BYTES; i++) {
            reader.accept(random.nextBoolean() ? likely[random.nextInt(likely.length)] : random.nextInt(256));
        }
        assertTrue("seed " + Fuzz.SEED, messages[0] > 1000);
    }
}
