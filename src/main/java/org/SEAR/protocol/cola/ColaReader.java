// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.cola;

import java.io.ByteArrayOutputStream;
import java.util.function.Consumer;

/**
 * Finds telegrams of CoLa A and B, also mixed, in a stream of bytes. Skips bytes between telegrams, too long telegrams,
 * and wrong checksums. Holds at most one telegram. One thread at a time.
 */
public final class ColaReader {
    private static final int LENGTH_BYTES = 4;

    private enum State { OUTSIDE, STX, TEXT, LENGTH, BINARY, CHECKSUM }

    private final int longest;
    private final Consumer<ColaTelegram> telegrams;
    private final ByteArrayOutputStream payload = new ByteArrayOutputStream();
    private State state = State.OUTSIDE;
    private int count;
    private long length;

    /**
     * @param longest length of a payload, bytes; longer ones are skipped
     * @param telegrams receives each telegram
     */
    public ColaReader(int longest, Consumer<ColaTelegram> telegrams) {
        this.longest = longest;
        this.telegrams = telegrams;
    }

    /** Takes bytes in pieces of any size. */
    public void accept(byte[] bytes) {
        for (byte value : bytes) {
            accept(value);
        }
    }

    /**
     * Takes the next byte.
     *
     * @param value only its low eight bits count
     */
    public void accept(int value) {
        int b = value & 0xFF;
        switch (state) {
            case OUTSIDE:
                begin(b);
                break;
            case STX:
                afterStx(b);
                break;
            case TEXT:
                text(b);
                break;
            case LENGTH:
                length(b);
                break;
            case BINARY:
                binary(b);
                break;
            default:
                byte[] bytes = payload.toByteArray();
                clear();
                if (ColaDialect.checksum(bytes, bytes.length) == b) {
                    telegrams.accept(new ColaTelegram(ColaDialect.B, bytes));
                }
                break;
        }
    }

    private void begin(int b) {
        clear();
        if (b == ColaDialect.STX) {
            state = State.STX;
            count = 1;
        }
    }

    private void afterStx(int b) {
        if (b != ColaDialect.STX) {
            state = State.TEXT;
            text(b);
        } else if (++count == ColaDialect.STX_OF_B) {
            state = State.LENGTH;
            count = 0;
        }
    }

    private void text(int b) {
        if (b == ColaDialect.ETX) {
            byte[] bytes = payload.toByteArray();
            clear();
            telegrams.accept(new ColaTelegram(ColaDialect.A, bytes));
        } else if (b == ColaDialect.STX || payload.size() == longest) {
            begin(b);
        } else {
            payload.write(b);
        }
    }

    private void length(int b) {
        length = length << 8 | b;
        if (++count == LENGTH_BYTES) {
            if (length > longest) {
                clear();
            } else {
                state = length == 0 ? State.CHECKSUM : State.BINARY;
            }
        }
    }

    private void binary(int b) {
        payload.write(b);
        if (payload.size() == length) {
            state = State.CHECKSUM;
        }
    }

    /** Whether part of a telegram has arrived. */
    public boolean isPending() {
        return state != State.OUTSIDE;
    }

    /** Discards an incomplete telegram. */
    public void clear() {
        payload.reset();
        state = State.OUTSIDE;
        count = 0;
        length = 0;
    }
}
