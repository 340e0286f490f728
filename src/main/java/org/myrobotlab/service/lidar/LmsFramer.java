package org.myrobotlab.service.lidar;

import java.util.Arrays;

/**
 * Finds acknowledgements and telegrams of an LMS2xx in a stream of bytes, and starts over after garbage.
 *
 * <p>Wire form (LMS2xx telegram listing, sections 4 to 6): {@code 02 | address | length low, high | command, data, status | CRC low, high}; the
 * device's address has bit 7 set. A bare {@code 06} acknowledges, a bare {@code 15} refuses a request. Any one thread at a time.
 */
final class LmsFramer {
    /** Start of a telegram. */
    static final int STX = 0x02;
    /** A request came whole. */
    static final int ACK = 0x06;
    /** A request came damaged. */
    static final int NAK = 0x15;
    /** Bytes before the command: start, address, length. */
    static final int HEADER = 4;
    /** Bytes of the check sum. */
    static final int CRC = 2;

    /** Longest command, data and status: 401 values with count, indices and status, rounded up (telegram listing, section 7.5). */
    private static final int LONGEST = 1024;
    private static final int REPLY_BIT = 0x80;

    /** Takes what was found. */
    interface Sink {
        void acknowledged();

        void refused();

        /** @param body command, data and status byte */
        void telegram(byte[] body);
    }

    private final byte[] buffer = new byte[HEADER + LONGEST + CRC];
    private int filled;
    private int resets;
    private long dropped;

    /** Takes bytes as they come, in pieces of any size. */
    void feed(byte[] bytes, Sink sink) {
        for (byte b : bytes) {
            buffer[filled++] = b;
            scan(sink);
        }
    }

    /** Forgets a telegram that was begun; what takes a telegram may call it, too. */
    void reset() {
        filled = 0;
        resets++;
    }

    /** Bytes ever thrown away because they belong to no telegram. */
    long getDropped() {
        return dropped;
    }

    private void scan(Sink sink) {
        while (filled > 0) {
            int before = resets;
            int used = consume(sink);
            if (used == 0 || resets != before) {
                return;
            }
            System.arraycopy(buffer, used, buffer, 0, filled - used);
            filled -= used;
        }
    }

    /** How many bytes at the front are done with; 0 while the telegram there is not whole. */
    private int consume(Sink sink) {
        int first = buffer[0] & 0xFF;
        if (first == ACK) {
            sink.acknowledged();
            return 1;
        }
        if (first == NAK) {
            sink.refused();
            return 1;
        }
        if (!couldStartHere()) {
            dropped++;
            return 1;
        }
        if (filled < HEADER || filled < HEADER + length() + CRC) {
            return 0;
        }
        int end = HEADER + length();
        if (word(end) != LmsTelegram.crc(buffer, end)) {
            dropped++;
            return 1;
        }
        sink.telegram(Arrays.copyOfRange(buffer, HEADER, end));
        return end + CRC;
    }

    private boolean couldStartHere() {
        return (buffer[0] & 0xFF) == STX && (filled < 2 || (buffer[1] & REPLY_BIT) != 0)
            && (filled < HEADER || length() > 0 && length() <= LONGEST);
    }

    private int length() {
        return word(2);
    }

    private int word(int at) {
        return buffer[at] & 0xFF | (buffer[at + 1] & 0xFF) << 8;
    }
}
