// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.mrlcomm;

import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.IntConsumer;

/**
 * Finds frames in a stream of bytes. Skips bytes between frames, and frames with a size of 0 or above 64, an unknown
 * function, or missing arguments. One thread at a time.
 */
public final class MrlReader {
    private final Consumer<MrlMessage> messages;
    private final IntConsumer unknown;
    private final byte[] arguments = new byte[MrlMessage.MOST];
    private State state = State.IDLE;
    private int left;
    private int function;
    private int count;

    private enum State { IDLE, SIZE, FUNCTION, ARGUMENTS }

    /** @param unknown receives the function of a skipped frame */
    public MrlReader(Consumer<MrlMessage> messages, IntConsumer unknown) {
        this.messages = messages;
        this.unknown = unknown;
    }

    /** @param value 0 to 255 */
    public void accept(int value) {
        switch (state) {
            case SIZE:
                left = value;
                state = value < 1 || value > MrlMessage.MOST ? State.IDLE : State.FUNCTION;
                break;
            case FUNCTION:
                function = value;
                count = 0;
                left--;
                state = State.ARGUMENTS;
                endIfWhole();
                break;
            case ARGUMENTS:
                arguments[count++] = (byte) value;
                left--;
                endIfWhole();
                break;
            default:
                state = value == MrlMessage.MAGIC ? State.SIZE : State.IDLE;
                break;
        }
    }

    private void endIfWhole() {
        if (left > 0) {
            return;
        }
        state = State.IDLE;
        MrlMessage message = new MrlMessage(function, Arrays.copyOf(arguments, count));
        if (message.isWhole()) {
            messages.accept(message);
        } else {
            unknown.accept(function);
        }
    }

    /** Discards an incomplete frame. */
    public void clear() {
        state = State.IDLE;
    }
}
