package org.SEAR.protocol.ubx;

import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.IntConsumer;

/**
 * Finds UBX frames in a stream of bytes, which other things, NMEA sentences mostly, stand between. A damaged frame is counted and left out, and what
 * stands in it is looked through again, so that a frame that noise has seemed to begin costs no good one. Any one thread at a time.
 */
public final class UbxReader {
    private static final int BYTE = 0xFF;
    private static final int BITS = 8;
    private static final int LENGTH_AT = 4;

    private final Consumer<UbxFrame> frames;
    private final IntConsumer others;
    private final byte[] buffer = new byte[UbxFrame.OVERHEAD + UbxFrame.MOST];
    private int filled;
    private long damaged;

    /**
     * @param frames gets each good frame
     * @param others gets each byte that belongs to no frame, 0 to 255
     */
    public UbxReader(Consumer<UbxFrame> frames, IntConsumer others) {
        this.frames = frames;
        this.others = others;
    }

    /** Takes bytes as they come, in pieces of any size. */
    public void feed(byte[] bytes) {
        for (byte b : bytes) {
            accept(b);
        }
    }

    /**
     * Takes the next byte.
     *
     * @param value its lowest eight bits count
     */
    public void accept(int value) {
        buffer[filled++] = (byte) value;
        while (filled > 0) {
            int wanted = wanted();
            if (wanted > filled) {
                return;
            }
            drop(wanted == 0 ? 1 : take(wanted));
        }
    }

    /** Bytes of the frame that the buffer begins with, as far as can be told, 0 if none does. */
    private int wanted() {
        if ((buffer[0] & BYTE) != UbxFrame.SYNC_1 || filled > 1 && (buffer[1] & BYTE) != UbxFrame.SYNC_2) {
            return 0;
        }
        if (filled < UbxFrame.HEADER) {
            return UbxFrame.HEADER;
        }
        int length = length();
        damaged += length > UbxFrame.MOST ? 1 : 0;
        return length > UbxFrame.MOST ? 0 : UbxFrame.OVERHEAD + length;
    }

    private int length() {
        return word(LENGTH_AT);
    }

    private int word(int at) {
        return buffer[at] & BYTE | (buffer[at + 1] & BYTE) << BITS;
    }

    /** Hands on a whole frame, if it is good; says how many bytes are dealt with. */
    private int take(int size) {
        if (word(size - 2) != UbxFrame.checksum(buffer, 2, size - UbxFrame.OVERHEAD + UbxFrame.HEADER - 2)) {
            damaged++;
            return 1;
        }
        UbxFrame frame = new UbxFrame(buffer[2] & BYTE, buffer[3] & BYTE, Arrays.copyOfRange(buffer, UbxFrame.HEADER, size - 2));
        drop(size);
        frames.accept(frame);
        return 0;
    }

    private void drop(int count) {
        if (count == 1) {
            others.accept(buffer[0] & BYTE);
        }
        filled = Math.max(0, filled - count);
        System.arraycopy(buffer, count, buffer, 0, filled);
    }

    /** Frames ever left out because their check sum was wrong or they were longer than any. */
    public long getDamaged() {
        return damaged;
    }

    /** Forgets a frame that was begun. */
    public void reset() {
        filled = 0;
    }
}
