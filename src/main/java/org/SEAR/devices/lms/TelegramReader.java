package org.SEAR.devices.lms;

import java.util.function.IntPredicate;

/**
 * Finds telegrams in a stream of bytes, whatever lies between them. After a telegram with a wrong checksum its bytes are looked through again, so a
 * stray STX never costs the good telegram that follows it. Holds at most one telegram of {@link Telegram#MAX_PAYLOAD}. One thread.
 */
public final class TelegramReader {
    /** What a reader finds. */
    public interface Listener {
        /** A whole telegram with the right checksum. */
        void onTelegram(Telegram telegram, double time);

        /** A whole telegram with a wrong checksum, for one of the addresses. @param crc the one received, @param bytes from STX on, not to be kept */
        void onWrongChecksum(byte[] bytes, int size, int crc, double time);
    }

    private final byte[] buffer = new byte[Telegram.MAX_PAYLOAD + Telegram.FRAME_SIZE];
    private final IntPredicate addresses;
    private final Listener listener;
    private int size;
    private boolean second;

    /** @param addresses which address bytes are looked at; telegrams for others pass unseen */
    public TelegramReader(IntPredicate addresses, Listener listener) {
        this.addresses = addresses;
        this.listener = listener;
    }

    /** Takes the next byte. @param value 0 to 255 @param time simulated seconds, handed on to the listener */
    public void accept(int value, double time) {
        if (size == 0 && value != Telegram.STX) {
            return;
        }
        buffer[size++] = (byte) value;
        parse(time);
    }

    /** Whether part of a telegram is there. */
    public boolean isPending() {
        return size > 0;
    }

    /** The rest of a begun telegram will not come: whatever whole telegrams its bytes hold are found, then all is forgotten. */
    public void interrupt(double time) {
        while (size > 0) {
            discard(1);
            second = true;
            parse(time);
        }
        second = false;
    }

    /** Forgets what came so far. */
    public void clear() {
        size = 0;
        second = false;
    }

    private void parse(double time) {
        while (size >= Telegram.HEADER_SIZE) {
            int length = buffer[2] & 0xFF | (buffer[3] & 0xFF) << 8;
            if (length == 0 || length > Telegram.MAX_PAYLOAD) {
                discard(1);
                continue;
            }
            int total = length + Telegram.FRAME_SIZE;
            if (size < total) {
                return;
            }
            finish(length, total, time);
        }
        if (size == 0) {
            second = false;
        }
    }

    private void finish(int length, int total, double time) {
        int crc = buffer[total - 2] & 0xFF | (buffer[total - 1] & 0xFF) << 8;
        boolean mine = addresses.test(buffer[1] & 0xFF);
        if (crc == Telegram.crc(buffer, 0, total - 2)) {
            byte[] payload = new byte[length];
            System.arraycopy(buffer, Telegram.HEADER_SIZE, payload, 0, length);
            int address = buffer[1] & 0xFF;
            discard(total);
            second = false;
            if (mine) {
                listener.onTelegram(new Telegram(address, payload), time);
            }
            return;
        }
        if (mine && !second) {
            listener.onWrongChecksum(buffer, total, crc, time);
        }
        second = true;
        discard(1);
    }

    /** Drops bytes, then everything up to the next STX. */
    private void discard(int count) {
        int from = count;
        while (from < size && buffer[from] != Telegram.STX) {
            from++;
        }
        System.arraycopy(buffer, from, buffer, 0, size - from);
        size -= from;
    }
}
