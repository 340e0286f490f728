// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.cola;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Builds a telegram value by value, in either dialect. In CoLa A each value is a word after a space, in hexadecimal
 * without leading zeros. In CoLa B it is one, two or four bytes, high byte first. One thread at a time.
 */
public final class ColaPayload {
    private static final int HEX_DIGIT = 4;
    private static final int INT_DIGITS = 8;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final ColaDialect dialect;

    public ColaPayload(ColaDialect dialect) {
        this.dialect = dialect;
    }

    /** Appends a command or answer without a name: {@code sFA}. */
    public ColaPayload verb(String verb) {
        return ascii(verb);
    }

    /**
     * Appends command or answer with its name; in CoLa B a space ends the name.
     *
     * @param verb {@code sRA}
     * @param name {@code STlms}
     */
    public ColaPayload begin(String verb, String name) {
        ascii(verb).ascii(" ").ascii(name);
        return dialect == ColaDialect.B ? ascii(" ") : this;
    }

    /** Appends one byte, 0 to 255. */
    public ColaPayload u1(int value) {
        return number(value & 0xFF, 1);
    }

    /** Appends two bytes, 0 to 65535. */
    public ColaPayload u2(int value) {
        return number(value & 0xFFFF, 2);
    }

    /** Appends four bytes in two's complement. */
    public ColaPayload i4(int value) {
        return number(value, 4);
    }

    private ColaPayload number(int value, int size) {
        if (dialect == ColaDialect.A) {
            bytes.write(' ');
            int digits = Math.max(1, INT_DIGITS - Integer.numberOfLeadingZeros(value) / HEX_DIGIT);
            digits(value, digits);
        } else {
            for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) {
                bytes.write(value >> shift);
            }
        }
        return this;
    }

    private void digits(int value, int count) {
        for (int shift = HEX_DIGIT * (count - 1); shift >= 0; shift -= HEX_DIGIT) {
            bytes.write("0123456789ABCDEF".charAt(value >>> shift & 0xF));
        }
    }

    /** Appends a 32-bit float; in CoLa A always eight digits. */
    public ColaPayload real(float value) {
        int bits = Float.floatToIntBits(value);
        if (dialect == ColaDialect.A) {
            bytes.write(' ');
            digits(bits, INT_DIGITS);
            return this;
        }
        return number(bits, 4);
    }

    /** Appends a text of fixed length: {@code DIST1}. */
    public ColaPayload fixed(String text) {
        return dialect == ColaDialect.A ? ascii(" ").ascii(text) : ascii(text);
    }

    /** Appends a text after its length. */
    public ColaPayload text(String text) {
        u2(text.length());
        return text.isEmpty() ? this : fixed(text);
    }

    private ColaPayload ascii(String text) {
        byte[] ascii = text.getBytes(StandardCharsets.ISO_8859_1);
        bytes.write(ascii, 0, ascii.length);
        return this;
    }

    /** Returns the telegram with its frame. */
    public byte[] toTelegram() {
        return dialect.frame(bytes.toByteArray());
    }
}
