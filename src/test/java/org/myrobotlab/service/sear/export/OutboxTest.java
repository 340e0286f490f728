// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import org.SEAR.Bytes;
import org.junit.Test;

/** The bytes that wait for a program. */
public class OutboxTest {
    private final Outbox outbox = new Outbox(bytes -> bytes);
    private final ByteArrayOutputStream program = new ByteArrayOutputStream();

    private int add(String bytes, int... starts) {
        return outbox.add(Bytes.bytes(bytes), starts);
    }

    /** @return what the program has, after it has taken so many bytes */
    private String take(int room) {
        int[] left = {room};
        outbox.flush((bytes, from, count) -> {
            int taken = Math.min(left[0], Math.min(2, count));
            program.write(bytes, from, taken);
            left[0] -= taken;
            return taken;
        });
        String taken = Bytes.hex(program.toByteArray());
        program.reset();
        return taken;
    }

    @Test
    public void aBegunMessageIsKeptAndOthersAreDropped() {
        assertEquals(0, add("01 02 03", 0));
        assertEquals("01", take(1));
        assertEquals("a second, its rest, and a third", 2, add("04 05 06", 1, 2));
        assertEquals(0, add("07"));
        assertEquals("02 03 04", take(9));
        assertEquals("a dropped message stays dropped", 0, add("08"));
        assertTrue(outbox.isEmpty());
        assertEquals(0, add("09 0A 0B", 1, 2));
        assertEquals("0A 0B", take(9));
    }

    @Test
    public void aProgramBeginsWithAWholeMessage() {
        assertEquals(0, add("01 02 03", 2));
        outbox.clear();
        assertEquals(0, add("04 05 06", 1));
        assertEquals("05 06", take(9));
    }

    @Test
    public void repliesAreBounded() {
        for (int i = 0; i < 10_000; i++) {
            outbox.reply(new byte[3]);
        }
        take(Outbox.MAX_REPLIES);
        assertEquals("00 00", take(2));
        assertEquals(0, outbox.add(new byte[] {1}, new int[] {}));
        take(9);
        assertTrue(outbox.isEmpty());
    }

    @Test
    public void partsAreEncoded() {
        Outbox telnet = new Outbox(new Rfc2217(null, reply -> { })::encode);
        assertEquals(0, telnet.add(Bytes.bytes("FF 01 FF"), new int[] {0, 2}));
        telnet.flush((bytes, from, count) -> {
            program.write(bytes, from, count);
            return count;
        });
        assertEquals("FF FF 01 FF FF", Bytes.hex(program.toByteArray()));
    }
}
