// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.ubx;

import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.IntConsumer;

/**
 * Finds UBX frames in a stream of bytes, between NMEA sentences and other data. Counts and skips a damaged frame, then
 * searches its bytes again, so that noise never hides a valid frame. One thread at a time.
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
     * @param frames receives each valid frame
     * @param others receives each byte outside frames, 0 to 255
     */
    public UbxReader(Consumer<UbxFrame> frames, IntConsumer others) {
        this.frames = frames;
        this.others = others;
    }

    /** Takes bytes in pieces of any size. */
    public void feed(byte[] bytes) {
        for (byte b : bytes) {
            accept(b);
        }
    }

    /**
     * Takes the next byte.
     *
     * @param value only its low eight bits count
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

    /** Size of the frame at the start of the buffer as far as known, bytes; 0 if there is no frame. */
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

    /**
     * Delivers a complete frame if it is valid.
     *
     * @return number of bytes still to drop from the buffer
     */
    private int take(int size) {
        if (word(size - 2) != UbxFrame.checksum(buffer, 2, size - UbxFrame.OVERHEAD + UbxFrame.HEADER - 2)) {
            damaged++;
            return 1;
        }
        UbxFrame frame = new UbxFrame(buffer[2] & BYTE, buffer[3] & BYTE,
            Arrays.copyOfRange(buffer, UbxFrame.HEADER, size - 2));
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

    /** Total number of skipped frames with a wrong checksum or an excessive length. */
    public long getDamaged() {
        return damaged;
    }

    /** Discards an incomplete frame. */
    public void reset() {
        filled = 0;
    }
}
