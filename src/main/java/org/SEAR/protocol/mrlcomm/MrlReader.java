package org.SEAR.protocol.mrlcomm;

import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.IntConsumer;

/**
 * Finds frames in a stream of bytes. What doesn't begin one is left out, as is a frame with a size of 0 or above 64, one of an unknown function and
 * one that is too short for its function. One thread at a time.
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

    /** @param unknown takes the function of a frame that can't be understood */
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

    /** Forgets what is unfinished. */
    public void clear() {
        state = State.IDLE;
    }
}
