// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.mrlcomm;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * A message in either direction: {@code AA size function arguments}; the size counts function and arguments.
 * {@code AA 02 3A 44} reports the start of MrlComm 68. Immutable.
 */
public final class MrlMessage {
    /** First byte of a frame. */
    public static final int MAGIC = 0xAA;
    /** Maximum size of function and arguments, bytes. */
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

    /** Starts a message. */
    public static Builder of(MrlFunction function) {
        return new Builder(function);
    }

    /** Its function; null if this version does not have it. */
    public MrlFunction getFunction() {
        return MrlFunction.of(function);
    }

    /** Whether all arguments of the function are present. */
    public boolean isWhole() {
        MrlFunction known = getFunction();
        return known != null && known.fits(arguments);
    }

    /** Returns an argument of one byte, 0 to 255; {@code at} counts bytes after the function. */
    public int getByte(int at) {
        return arguments[at] & BYTE;
    }

    /** Returns an argument of two bytes, signed. */
    public int getShort(int at) {
        return (short) (getByte(at) << Byte.SIZE | getByte(at + 1));
    }

    /** Returns argument bytes. */
    public byte[] getBytes(int from, int to) {
        return Arrays.copyOfRange(arguments, from, to);
    }

    /** Returns a text or list: a length byte and its bytes. */
    public byte[] getList(int at) {
        return Arrays.copyOfRange(arguments, at + 1, at + 1 + getByte(at));
    }

    /** Returns the bytes on the line. */
    public byte[] toBytes() {
        byte[] frame = new byte[3 + arguments.length];
        frame[0] = (byte) MAGIC;
        frame[1] = (byte) (1 + arguments.length);
        frame[2] = (byte) function;
        System.arraycopy(arguments, 0, frame, 3, arguments.length);
        return frame;
    }

    /** Collects the arguments of a message. */
    public static final class Builder {
        private final MrlFunction function;
        private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

        Builder(MrlFunction function) {
            this.function = function;
        }

        /** Appends one byte, 0 to 255. */
        public Builder add(int value) {
            bytes.write(value);
            return this;
        }

        /** Appends two bytes. */
        public Builder addShort(int value) {
            return add(value >> Byte.SIZE).add(value);
        }

        /** Appends bytes. */
        public Builder addAll(byte[] values) {
            bytes.write(values, 0, values.length);
            return this;
        }

        /** Appends a list: its length and its bytes, cut to the space left. */
        public Builder addList(byte[] values) {
            int length = Math.min(values.length, MOST - 2 - bytes.size());
            add(length);
            bytes.write(values, 0, length);
            return this;
        }

        /** Appends a text as a list. */
        public Builder addText(String text) {
            return addList(text.getBytes(StandardCharsets.UTF_8));
        }

        /** Returns the message. */
        public MrlMessage end() {
            return new MrlMessage(function.getNumber(), bytes.toByteArray());
        }
    }
}
