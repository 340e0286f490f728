// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.cola;

import java.nio.charset.StandardCharsets;

/**
 * A telegram without its frame, with the position of the next value to read. Its first three letters are the verb
 * ({@code sRN}); name and values follow. Numbers of CoLa A are decimal with a sign and hexadecimal without:
 * {@code +5000} is {@code 1388}. One thread at a time.
 */
public final class ColaTelegram {
    private static final int VERB = 3;
    private static final int LONGEST_WORD = 12;
    private static final int HEX = 16;
    private static final int DECIMAL = 10;

    private final ColaDialect dialect;
    private final byte[] payload;
    private final String verb;
    private final String name;
    private int at;

    /** @param payload belongs to the telegram from now on */
    public ColaTelegram(ColaDialect dialect, byte[] payload) {
        this.dialect = dialect;
        this.payload = payload;
        at = Math.min(VERB, payload.length);
        verb = text(0, at);
        skipSpace();
        int from = at;
        at = endOfWord();
        name = text(from, at);
        if (dialect == ColaDialect.B) {
            skipSpace();
        }
    }

    private String text(int from, int to) {
        return new String(payload, from, to - from, StandardCharsets.ISO_8859_1);
    }

    private void skipSpace() {
        if (at < payload.length && payload[at] == ' ') {
            at++;
        }
    }

    private int endOfWord() {
        int end = at;
        while (end < payload.length && payload[end] != ' ') {
            end++;
        }
        return end;
    }

    public ColaDialect getDialect() {
        return dialect;
    }

    /**
     * Verb of a request, {@code sRN}, {@code sWN}, {@code sMN}, {@code sEN} or {@code sRI}, or of an answer,
     * {@code sRA}, {@code sSN} and so on.
     */
    public String getVerb() {
        return verb;
    }

    /** Name of the variable, method or event: {@code LMDscandata}. */
    public String getName() {
        return name;
    }

    /** Whether values are left to read. */
    public boolean hasMore() {
        return at < payload.length;
    }

    /**
     * Reads the next value, an unsigned byte.
     *
     * @throws ColaException if it is missing, no number, or too large
     */
    public int u1() throws ColaException {
        return unsigned(1);
    }

    /**
     * Reads the next value, an unsigned 16-bit number.
     *
     * @throws ColaException if it is missing, no number, or too large
     */
    public int u2() throws ColaException {
        return unsigned(2);
    }

    private int unsigned(int size) throws ColaException {
        long value = number(size);
        if (value < 0 || value >= 1L << 8 * size) {
            throw new ColaException(ColaError.VALUE_OVERFLOW);
        }
        return (int) value;
    }

    /**
     * Reads the next value, a signed 32-bit number.
     *
     * @throws ColaException if it is missing, no number, or does not fit
     */
    public int i4() throws ColaException {
        return (int) number(4);
    }

    private long number(int size) throws ColaException {
        if (dialect == ColaDialect.A) {
            return word();
        }
        if (payload.length - at < size) {
            throw new ColaException(ColaError.TOO_FEW_VALUES);
        }
        long value = 0;
        for (int i = 0; i < size; i++) {
            value = value << 8 | payload[at++] & 0xFF;
        }
        return value;
    }

    private long word() throws ColaException {
        skipSpace();
        int end = endOfWord();
        if (end == at) {
            throw new ColaException(ColaError.TOO_FEW_VALUES);
        }
        String word = end - at > LONGEST_WORD ? "" : text(at, end);
        at = end;
        boolean signed = word.startsWith("+") || word.startsWith("-");
        if (!word.matches(signed ? ".[0-9]+" : "[0-9A-Fa-f]+")) {
            throw new ColaException(ColaError.INVALID_CHARACTER);
        }
        long value = Long.parseLong(word, signed ? DECIMAL : HEX);
        if (value < Integer.MIN_VALUE || value > 0xFFFFFFFFL) {
            throw new ColaException(ColaError.VALUE_OVERFLOW);
        }
        return value;
    }

    /**
     * Reads the next value, a text after its length.
     *
     * @throws ColaException if it is shorter than its length
     */
    public String text() throws ColaException {
        int length = u2();
        if (dialect == ColaDialect.A) {
            skipSpace();
        }
        return take(length);
    }

    /**
     * Reads the next value, a text of fixed length.
     *
     * @throws ColaException if it is shorter
     */
    public String fixed(int length) throws ColaException {
        if (dialect == ColaDialect.A) {
            skipSpace();
        }
        return take(length);
    }

    private String take(int length) throws ColaException {
        if (payload.length - at < length) {
            throw new ColaException(ColaError.TOO_FEW_VALUES);
        }
        at += length;
        return text(at - length, at);
    }

    /** Returns the payload as text; binary values are unreadable. */
    @Override
    public String toString() {
        return text(0, payload.length);
    }
}
