package org.SEAR.devices.lms;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Builds command, data and status of a reply. */
final class Payload {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    Payload(int command) {
        bytes.write(command);
    }

    Payload add(int value) {
        bytes.write(value);
        return this;
    }

    Payload word(int value) {
        bytes.write(value);
        bytes.write(value >> 8);
        return this;
    }

    Payload words(int... values) {
        for (int value : values) {
            word(value);
        }
        return this;
    }

    Payload doubleWord(int value) {
        return word(value).word(value >>> 16);
    }

    Payload text(String text) {
        return bytes(text.getBytes(StandardCharsets.US_ASCII));
    }

    Payload bytes(byte[] values) {
        bytes.write(values, 0, values.length);
        return this;
    }

    byte[] toBytes() {
        return bytes.toByteArray();
    }
}
