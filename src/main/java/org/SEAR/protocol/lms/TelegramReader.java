// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * Finds telegrams in a stream of bytes with anything between them. After a wrong checksum it searches the same bytes
 * again, so that a stray STX never hides a valid telegram. Holds at most one telegram of {@link Telegram#MAX_PAYLOAD}.
 * One thread at a time.
 */
public final class TelegramReader {
    /** Receives telegrams and stray bytes; may call {@link #clear}. */
    public interface Listener {
        /** A complete telegram with a valid checksum. */
        void onTelegram(Telegram telegram);

        /**
         * A byte that belongs to no telegram: a bare ACK or NAK, or garbage.
         *
         * @param value 0 to 255
         */
        default void onStray(int value) {
        }

        /**
         * A complete telegram with a wrong checksum. Further wrong telegrams within its bytes are not reported.
         *
         * @param bytes from STX to checksum
         */
        default void onWrongChecksum(byte[] bytes) {
        }
    }

    private final byte[] buffer = new byte[Telegram.MAX_PAYLOAD + Telegram.FRAME_SIZE];
    private final IntPredicate addresses;
    private final Listener listener;
    private int size;
    private boolean second;
    private boolean cleared;

    /** @param addresses legal address bytes of a telegram; an STX before another byte starts none */
    public TelegramReader(IntPredicate addresses, Listener listener) {
        this.addresses = addresses;
        this.listener = listener;
    }

    /**
     * Takes the next byte.
     *
     * @param value only its low eight bits count
     */
    public void accept(int value) {
        buffer[size++] = (byte) value;
        parse();
    }

    /** Takes bytes in pieces of any size. */
    public void accept(byte[] bytes) {
        for (byte value : bytes) {
            accept(value);
        }
    }

    /** Whether part of a telegram has arrived. */
    public boolean isPending() {
        return size > 0;
    }

    /** Ends an incomplete telegram: finds complete telegrams within its bytes, then discards all. */
    public void interrupt() {
        while (size > 0) {
            second = true;
            discardOne();
            parse();
        }
        second = false;
    }

    /** Discards all bytes so far. */
    public void clear() {
        size = 0;
        second = false;
        cleared = true;
    }

    private void parse() {
        while (size > 0) {
            if (!couldStartHere()) {
                discardOne();
            } else if (size < Telegram.HEADER_SIZE || size < total()) {
                return;
            } else {
                finish(total());
            }
        }
        second = false;
    }

    private boolean couldStartHere() {
        return buffer[0] == Telegram.STX && (size < 2 || addresses.test(buffer[1] & 0xFF))
            && (size < Telegram.HEADER_SIZE || word(2) > 0 && word(2) <= Telegram.MAX_PAYLOAD);
    }

    private int total() {
        return word(2) + Telegram.FRAME_SIZE;
    }

    private int word(int at) {
        return buffer[at] & 0xFF | (buffer[at + 1] & 0xFF) << 8;
    }

    private void finish(int total) {
        int end = total - Telegram.CRC_SIZE;
        if (word(end) == Telegram.crc(buffer, 0, end)) {
            Telegram telegram = new Telegram(buffer[1] & 0xFF, Arrays.copyOfRange(buffer, Telegram.HEADER_SIZE, end));
            second = false;
            drop(total);
            listener.onTelegram(telegram);
            return;
        }
        cleared = false;
        if (!second) {
            listener.onWrongChecksum(Arrays.copyOf(buffer, total));
        }
        if (!cleared) {
            second = true;
            discardOne();
        }
    }

    private void discardOne() {
        int stray = buffer[0] & 0xFF;
        drop(1);
        listener.onStray(stray);
    }

    private void drop(int count) {
        size -= count;
        System.arraycopy(buffer, count, buffer, 0, size);
    }
}
