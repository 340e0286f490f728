package org.SEAR.protocol.lms;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Builds what a telegram carries: command, data and, in replies, the status byte. Words have their low byte first. */
public final class LmsPayload {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    public LmsPayload(int command) {
        bytes.write(command);
    }

    /** A byte. */
    public LmsPayload add(int value) {
        bytes.write(value);
        return this;
    }

    /** A word, low byte first. */
    public LmsPayload word(int value) {
        bytes.write(value);
        bytes.write(value >> 8);
        return this;
    }

    /** Words, one after the other. */
    public LmsPayload words(int... values) {
        for (int value : values) {
            word(value);
        }
        return this;
    }

    /** Four bytes, the lowest first. */
    public LmsPayload doubleWord(int value) {
        return word(value).word(value >>> 16);
    }

    /** ASCII text. */
    public LmsPayload text(String text) {
        return bytes(text.getBytes(StandardCharsets.US_ASCII));
    }

    /** Bytes as they are. */
    public LmsPayload bytes(byte[] values) {
        bytes.write(values, 0, values.length);
        return this;
    }

    /** A copy of what was built so far. */
    public byte[] toBytes() {
        return bytes.toByteArray();
    }
}
