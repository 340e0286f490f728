package org.SEAR.protocol.lms;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Builds what a telegram carries: command, data and, in replies, the status byte. Words have their low byte first. */
public final class Payload {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    public Payload(int command) {
        bytes.write(command);
    }

    /** A byte. */
    public Payload add(int value) {
        bytes.write(value);
        return this;
    }

    /** A word, low byte first. */
    public Payload word(int value) {
        bytes.write(value);
        bytes.write(value >> 8);
        return this;
    }

    /** Words, one after the other. */
    public Payload words(int... values) {
        for (int value : values) {
            word(value);
        }
        return this;
    }

    /** Four bytes, the lowest first. */
    public Payload doubleWord(int value) {
        return word(value).word(value >>> 16);
    }

    /** ASCII text. */
    public Payload text(String text) {
        return bytes(text.getBytes(StandardCharsets.US_ASCII));
    }

    /** Bytes as they are. */
    public Payload bytes(byte[] values) {
        bytes.write(values, 0, values.length);
        return this;
    }

    /** A copy of what was built so far. */
    public byte[] toBytes() {
        return bytes.toByteArray();
    }
}
