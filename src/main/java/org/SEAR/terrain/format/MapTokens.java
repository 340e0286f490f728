// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.IOException;
import org.SEAR.files.FileLimits;
import org.SEAR.terrain.tiff.MapBytes;

/** Splits a text at white space and parses numbers, reading the file piecewise. One thread at a time. */
final class MapTokens {
    private static final int LONGEST = 64;
    /** Maximum white space between two words, characters. */
    private static final int WIDEST = 1 << 16;
    /** Number of digits that a long and a double's mantissa hold exactly. */
    private static final int PLAIN = 15;
    private static final double[] POWERS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13,
        1e14, 1e15};

    private final MapBytes file;
    private final byte[] piece = new byte[1 << 16];
    private final char[] word = new char[LONGEST];
    private long position;
    private int filled;
    private int at;
    private int length;

    MapTokens(MapBytes file) {
        this.file = file;
    }

    private int read() throws IOException {
        if (at == filled) {
            filled = (int) Math.min(piece.length, file.size() - position);
            at = 0;
            if (filled == 0) {
                return -1;
            }
            file.read("the text", position, piece, filled);
            position += filled;
        }
        return piece[at++] & 0xff;
    }

    /** Reads the next word. Returns false at the end. */
    boolean next() throws IOException {
        length = 0;
        int c = read();
        for (int white = 0; isWhite(c); white++) {
            if (white == WIDEST) {
                throw FileLimits.wrong(file.getName(), "the white space before byte " + place(), "more than " + WIDEST
                    + " characters", "less");
            }
            c = read();
        }
        if (c >= 0 && c < ' ') {
            throw FileLimits.wrong(file.getName(), "the character at byte " + place(), c,
                "text: numbers of an ESRI ASCII grid (is it another or an incomplete file?)");
        }
        while (c > ' ') {
            if (length == LONGEST) {
                throw FileLimits.wrong(file.getName(), "the text", '"' + text() + "...\"",
                    "numbers of an ESRI ASCII grid");
            }
            word[length++] = (char) c;
            c = read();
        }
        return length > 0;
    }

    private static boolean isWhite(int c) {
        return c == ' ' || c >= '\t' && c <= '\r';
    }

    /** Returns the position of the last character in the file. */
    private long place() {
        return position - filled + at - 1;
    }

    /** Returns the word; empty at the end. */
    String text() {
        return new String(word, 0, length);
    }

    /** Returns the word as the elevation of a post. Short numbers, which most are, need no string. */
    double number(int post, int columns) throws IOException {
        int start = length > 0 && word[0] == '-' ? 1 : 0;
        long value = 0;
        int point = length;
        boolean plain = length > start && length <= PLAIN;
        for (int i = start; i < length && plain; i++) {
            if (word[i] == '.' && point == length && length > start + 1) {
                point = i;
            } else {
                plain = word[i] >= '0' && word[i] <= '9';
                value = value * 10 + word[i] - '0';
            }
        }
        if (!plain) {
            return number(file.getName(), "the height in row " + post / columns + ", column " + post % columns
                + ",", text());
        }
        double scaled = value / POWERS[Math.max(0, length - 1 - point)];
        return start == 1 ? -scaled : scaled;
    }

    /**
     * Parses a word as a number.
     * @param what its name in messages
     * @throws IOException if the word is missing or no number
     */
    static double number(String file, String what, String text) throws IOException {
        if (text.isEmpty()) {
            throw FileLimits.wrong(file, what, "missing", "a number (is the file cut off?)");
        }
        if (text.equalsIgnoreCase("nan")) {     // GDAL writes nan for no data
            return Double.NaN;
        }
        try {
            return Double.parseDouble(text.replace(',', '.'));
        } catch (NumberFormatException e) {
            throw FileLimits.wrong(file, what, '"' + text + '"', "a number");
        }
    }
}
