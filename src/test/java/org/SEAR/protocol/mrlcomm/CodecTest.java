// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.mrlcomm;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.Golden;
import org.junit.Test;

/** Frames as in MyRobotLab's schema of messages. */
public class CodecTest {
    private static final Golden MRL_COMM = Golden.of("mrlcomm");
    private final List<MrlMessage> found = new ArrayList<>();
    private final List<Integer> unknown = new ArrayList<>();
    private final MrlReader reader = new MrlReader(found::add, unknown::add);

    private void read(String hex) {
        for (int each : Bytes.ints(hex)) {
            reader.accept(each);
        }
    }

    @Test
    public void theHello() {
        assertEquals(MRL_COMM.get("hello of a board"),
            Bytes.hex(MrlMessage.of(MrlFunction.PUBLISH_BEGIN).add(MrlMessage.VERSION).end().toBytes()));
        assertEquals(MRL_COMM.get("ask for the board acknowledged"),
            Bytes.hex(MrlMessage.of(MrlFunction.PUBLISH_ACK).add(MrlFunction.GET_BOARD_INFO.getNumber()).end()
                .toBytes()));
        read(MRL_COMM.get("ask for the board"));
        assertEquals(MrlFunction.GET_BOARD_INFO, found.get(0).getFunction());
    }

    @Test
    public void everyFunctionHasItsNumber() {
        int number = 1;
        for (MrlFunction function : MrlFunction.values()) {
            assertEquals(number, function.getNumber());
            assertEquals(function, MrlFunction.of(number++));
        }
        assertEquals(59, MrlFunction.values().length);
        assertEquals(null, MrlFunction.of(0));
        assertEquals(null, MrlFunction.of(60));
    }

    @Test
    public void numbersAreBigEndianAndSigned() {
        read(MRL_COMM.get("attach the servo 3 at pin 10, 1500 us, as fast as it goes"));
        MrlMessage attach = found.get(0);
        assertEquals(MrlFunction.SERVO_ATTACH, attach.getFunction());
        assertEquals(3, attach.getByte(0));
        assertEquals(10, attach.getByte(1));
        assertEquals(1500, attach.getShort(2));
        assertEquals(-1, attach.getShort(4));
        assertEquals("servo", new String(attach.getList(6)));
        assertEquals("AA 06 2B 03 00 FF FF 90",
            Bytes.hex(MrlMessage.of(MrlFunction.PUBLISH_SERVO_EVENT).add(3).add(0).addShort(-1).add(0x90).end()
                .toBytes()));
    }

    @Test
    public void itFindsTheNextFrameInGarbage() {
        read("00 4D AA 00 AA 41 01 AA 03 1B 0D 01 AA 01 63 AA 02 1B 0D AA 01 02");
        assertEquals(2, found.size());
        assertEquals(MrlFunction.DIGITAL_WRITE, found.get(0).getFunction());
        assertEquals(MrlFunction.GET_BOARD_INFO, found.get(1).getFunction());
        assertEquals("a function 99 and a digitalWrite without its value", List.of(99, 27), unknown);
    }

    @Test
    public void aListIsCutToTheSizeOfAFrame() {
        byte[] frame = MrlMessage.of(MrlFunction.PUBLISH_DEBUG).addText(new String(new char[200]).replace('\0', 'x'))
            .end().toBytes();
        assertEquals(2 + 64, frame.length);
        assertEquals(64, frame[1]);
        read(Bytes.hex(frame));
        assertArrayEquals(new byte[] {'x', 'x'}, found.get(0).getBytes(61, 63));
        assertEquals(62, found.get(0).getList(0).length);
    }

    @Test
    public void aMillionRandomBytes() {
        Random random = new Random(Fuzz.SEED);
        int[] messages = new int[1];
        MrlReader fuzzed = new MrlReader(message -> {
            messages[0]++;
            byte[] frame = message.toBytes();
            assertTrue(frame.length <= 2 + MrlMessage.MOST);
            for (byte each : frame) {
                reader.accept(each & 0xFF);
            }
            assertArrayEquals(frame, found.remove(0).toBytes());
        }, number -> messages[0]++);
        for (int i = 0; i < Fuzz.BYTES; i++) {
            int kind = random.nextInt(4);
            fuzzed.accept(kind == 0 ? MrlMessage.MAGIC : kind == 1 ? random.nextInt(64) : random.nextInt(256));
        }
        assertTrue("seed " + Fuzz.SEED, messages[0] > 1000);
    }
}
