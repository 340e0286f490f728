// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import java.util.Arrays;
import java.util.function.UnaryOperator;

/**
 * Bytes for one program that its operating system has not taken yet. Drops whole messages only: while bytes of an
 * earlier call wait, the messages that begin are dropped, and a message that has begun is kept to its end. So an outbox
 * holds at most the messages of one call, the rest of the last one, and {@link #MAX_REPLIES} bytes. One thread at a
 * time.
 */
final class Outbox {
    /** Number of waiting bytes above which {@link #reply} drops, bytes. */
    static final int MAX_REPLIES = 4096;
    private static final int FIRST_SIZE = 256;

    /** Takes bytes without waiting. */
    interface Target<E extends Exception> {
        /** @return number of bytes taken, 0 or less if there is no room */
        int write(byte[] bytes, int from, int count) throws E;
    }

    private final UnaryOperator<byte[]> encoding;
    private byte[] waiting = new byte[FIRST_SIZE];
    private int from;
    private int end;
    /** Whether the present message is kept; false before the first message. */
    private boolean taking;

    /** @param encoding encodes a part of a message for the program */
    Outbox(UnaryOperator<byte[]> encoding) {
        this.encoding = encoding;
    }

    boolean isEmpty() {
        return from == end;
    }

    /** Drops all bytes, and those of the present message that follow. */
    void clear() {
        from = 0;
        end = 0;
        taking = false;
    }

    /**
     * Adds bytes of the device. Call {@link #flush} before, so that no bytes wait if the program has read.
     *
     * @param starts indices of the messages' first bytes, ascending
     * @return number of messages dropped
     */
    int add(byte[] bytes, int[] starts) {
        boolean full = !isEmpty();
        addPart(bytes, 0, starts.length == 0 ? bytes.length : starts[0]);
        for (int i = 0; i < starts.length; i++) {
            taking = !full;
            addPart(bytes, starts[i], i + 1 < starts.length ? starts[i + 1] : bytes.length);
        }
        return full ? starts.length : 0;
    }

    private void addPart(byte[] bytes, int first, int after) {
        if (taking && first < after) {
            append(encoding.apply(Arrays.copyOfRange(bytes, first, after)));
        }
    }

    /** Adds bytes that don't come from the device; drops them if more than {@link #MAX_REPLIES} bytes wait. */
    void reply(byte[] bytes) {
        if (end - from <= MAX_REPLIES) {
            append(bytes);
        }
    }

    private void append(byte[] bytes) {
        if (end + bytes.length > waiting.length) {
            int left = end - from;
            byte[] larger = left + bytes.length > waiting.length ? new byte[2 * (left + bytes.length)] : waiting;
            System.arraycopy(waiting, from, larger, 0, left);
            waiting = larger;
            from = 0;
            end = left;
        }
        System.arraycopy(bytes, 0, waiting, end, bytes.length);
        end += bytes.length;
    }

    /** Writes the waiting bytes, as far as the target takes them. */
    <E extends Exception> void flush(Target<E> target) throws E {
        for (int written = 1; written > 0 && !isEmpty();) {
            written = target.write(waiting, from, end - from);
            from += Math.max(0, written);
        }
        if (isEmpty()) {
            from = 0;
            end = 0;
        }
    }
}
