package org.SEAR.protocol.mrlcomm;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * A message in either direction: {@code AA size function arguments}, where size counts the function and its arguments; {@code AA 02 3A 44} says that
 * MrlComm 68 has begun. Immutable.
 */
public final class MrlMessage {
    /** First byte of a frame. */
    public static final int MAGIC = 0xAA;
    /** Most bytes of function and arguments. */
    public static final int MOST = 64;
    /** Version of the messages. */
    public static final int VERSION = 68;
    private static final int BYTE = 0xFF;

    private final int function;
    private final byte[] arguments;

    MrlMessage(int function, byte[] arguments) {
        this.function = function;
        this.arguments = arguments;
    }

    /** Begins a message. */
    public static Builder of(MrlFunction function) {
        return new Builder(function);
    }

    /** What it says; null for a function that this version doesn't have. */
    public MrlFunction getFunction() {
        return MrlFunction.of(function);
    }

    /** Whether all arguments of its function are there. */
    public boolean isWhole() {
        MrlFunction known = getFunction();
        return known != null && known.fits(arguments);
    }

    /** An argument of one byte, 0 to 255; {@code at} counts bytes after the function. */
    public int getByte(int at) {
        return arguments[at] & BYTE;
    }

    /** An argument of two bytes, signed. */
    public int getShort(int at) {
        return (short) (getByte(at) << Byte.SIZE | getByte(at + 1));
    }

    /** Arguments from a byte on. */
    public byte[] getBytes(int from, int to) {
        return Arrays.copyOfRange(arguments, from, to);
    }

    /** A text or list: a byte with its length, and its bytes. */
    public byte[] getList(int at) {
        return Arrays.copyOfRange(arguments, at + 1, at + 1 + getByte(at));
    }

    /** As it goes over the line. */
    public byte[] toBytes() {
        byte[] frame = new byte[3 + arguments.length];
        frame[0] = (byte) MAGIC;
        frame[1] = (byte) (1 + arguments.length);
        frame[2] = (byte) function;
        System.arraycopy(arguments, 0, frame, 3, arguments.length);
        return frame;
    }

    /** Puts the arguments of a message one behind the other. */
    public static final class Builder {
        private final MrlFunction function;
        private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

        Builder(MrlFunction function) {
            this.function = function;
        }

        /** One byte, 0 to 255. */
        public Builder add(int value) {
            bytes.write(value);
            return this;
        }

        /** Two bytes. */
        public Builder addShort(int value) {
            return add(value >> Byte.SIZE).add(value);
        }

        /** Bytes as they are. */
        public Builder addAll(byte[] values) {
            bytes.write(values, 0, values.length);
            return this;
        }

        /** A list: its length, and its bytes; as many as fit. */
        public Builder addList(byte[] values) {
            int length = Math.min(values.length, MOST - 2 - bytes.size());
            add(length);
            bytes.write(values, 0, length);
            return this;
        }

        /** A text, as a list. */
        public Builder addText(String text) {
            return addList(text.getBytes(StandardCharsets.UTF_8));
        }

        /** The message. */
        public MrlMessage end() {
            return new MrlMessage(function.getNumber(), bytes.toByteArray());
        }
    }
}
