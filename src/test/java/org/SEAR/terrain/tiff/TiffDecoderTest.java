// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.tiff;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.Test;

/** Unpacking and predictors, with bytes computed by hand. */
public class TiffDecoderTest {
    private static byte[] bytes(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            bytes[i] = (byte) values[i];
        }
        return bytes;
    }

    private static byte[] unpacked(int compression, int size, byte... packed) throws IOException {
        byte[] into = new byte[size];
        TiffDecoder.unpack("a.tif", "strip 0", compression, packed, into);
        return into;
    }

    /** The example of Apple's Technical Note 1023. */
    @Test
    public void packBits() throws IOException {
        byte[] packed = bytes(0xfe, 0xaa, 0x02, 0x80, 0x00, 0x2a, 0xfd, 0xaa, 0x03, 0x80, 0x00, 0x2a, 0x22, 0xf7, 0xaa);
        assertArrayEquals(bytes(0xaa, 0xaa, 0xaa, 0x80, 0x00, 0x2a, 0xaa, 0xaa, 0xaa, 0xaa, 0x80, 0x00, 0x2a, 0x22,
            0xaa, 0xaa, 0xaa, 0xaa, 0xaa, 0xaa, 0xaa, 0xaa, 0xaa, 0xaa), unpacked(32773, 24, packed));
        assertArrayEquals(bytes(0xaa, 0xaa), unpacked(32773, 2, packed));
    }

    /** Codes 256, 7, 258 (which stands for 7 7 and is defined only while it is read), 7, 257, of nine bits each. */
    @Test
    public void lzwWithACodeThatIsMadeWhileItIsRead() throws IOException {
        byte[] packed = codes(256, 7, 258, 7, 257);
        assertArrayEquals(bytes(7, 7, 7, 7), unpacked(5, 4, packed));
    }

    @Test
    public void invalidLzw() {
        IOException e = assertThrows(IOException.class, () -> unpacked(5, 4, codes(256, 300, 257)));
        assertTrue(e.getMessage(), e.getMessage().contains("a.tif: strip 0 is broken (an undefined LZW code)"));
        IOException cut = assertThrows(IOException.class, () -> unpacked(5, 4, codes(256, 1, 257)));
        assertTrue(cut.getMessage(), cut.getMessage().contains("strip 0 is cut off after 1 bytes, legal: at least 4"));
    }

    private static byte[] codes(int... codes) {
        byte[] packed = new byte[(9 * codes.length + 7) / 8];
        for (int i = 0; i < 9 * codes.length; i++) {
            packed[i / 8] |= (byte) ((codes[i / 9] >> 8 - i % 9 & 1) << 7 - i % 8);
        }
        return packed;
    }

    @Test
    public void differencesOfAllSizes() {
        byte[] colours = bytes(10, 20, 30, 1, 2, 3, 255, 0, 1);
        TiffPredictor.undo(2, colours, 0, 3, 3, 1, ByteOrder.LITTLE_ENDIAN);
        assertArrayEquals(bytes(10, 20, 30, 11, 22, 33, 10, 22, 34), colours);
        for (ByteOrder order : new ByteOrder[] {ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN}) {
            ByteBuffer shorts = ByteBuffer.allocate(8).order(order).putShort((short) 9).putShort((short) 300)
                .putShort((short) -310).putShort((short) 1);
            TiffPredictor.undo(2, shorts.array(), 2, 3, 1, 2, order);
            assertArrayEquals(ByteBuffer.allocate(8).order(order).putShort((short) 9).putShort((short) 300)
                .putShort((short) -10).putShort((short) -9).array(), shorts.array());
            ByteBuffer longs = ByteBuffer.allocate(16).order(order).putLong(1L << 40).putLong(-1);
            TiffPredictor.undo(2, longs.array(), 0, 2, 1, 8, order);
            assertArrayEquals(ByteBuffer.allocate(16).order(order).putLong(1L << 40).putLong((1L << 40) - 1).array(),
                longs.array());
            ByteBuffer ints = ByteBuffer.allocate(8).order(order).putInt(100000).putInt(5);
            TiffPredictor.undo(2, ints.array(), 0, 2, 1, 4, order);
            assertArrayEquals(ByteBuffer.allocate(8).order(order).putInt(100000).putInt(100005).array(), ints.array());
        }
    }

    /** 1.5 and -2 are 3f c0 00 00 and c0 00 00 00; by rank 3f c0, c0 00, 00 00, 00 00, stored as differences. */
    @Test
    public void floatsSortedByRank() {
        byte[] row = bytes(0x3f, 0xc0 - 0x3f, 0, 0x00 - 0xc0, 0, 0, 0, 0);
        TiffPredictor.undo(3, row, 0, 2, 1, 4, ByteOrder.LITTLE_ENDIAN);
        assertArrayEquals(ByteBuffer.allocate(8).putFloat(1.5f).putFloat(-2).array(), row);
    }
}
