// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Builds the payload of a telegram: command, data and, in replies, the status byte. Words have their low byte first.
 */
public final class LmsPayload {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    public LmsPayload(int command) {
        bytes.write(command);
    }

    /** Appends a byte. */
    public LmsPayload add(int value) {
        bytes.write(value);
        return this;
    }

    /** Appends a word, low byte first. */
    public LmsPayload word(int value) {
        bytes.write(value);
        bytes.write(value >> 8);
        return this;
    }

    /** Appends words in order. */
    public LmsPayload words(int... values) {
        for (int value : values) {
            word(value);
        }
        return this;
    }

    /** Appends four bytes, lowest first. */
    public LmsPayload doubleWord(int value) {
        return word(value).word(value >>> 16);
    }

    /** Appends ASCII text. */
    public LmsPayload text(String text) {
        return bytes(text.getBytes(StandardCharsets.US_ASCII));
    }

    /** Appends bytes. */
    public LmsPayload bytes(byte[] values) {
        bytes.write(values, 0, values.length);
        return this;
    }

    /** Returns a copy of the bytes so far. */
    public byte[] toBytes() {
        return bytes.toByteArray();
    }
}
