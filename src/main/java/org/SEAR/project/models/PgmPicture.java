// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import java.io.IOException;
import org.SEAR.files.FileLimits;

/** Reader of a portable grey map (.pgm), binary (P5) or text (P2). One use. */
final class PgmPicture {
    private static final int MOST_GREY = 65535;
    private static final int BYTE = 255;
    private static final int LONGEST_SIDE = 1 << 20;

    private final byte[] bytes;
    private final String file;
    private int at;

    private PgmPicture(byte[] bytes, String file) {
        this.bytes = bytes;
        this.file = file;
    }

    /**
     * Returns the brightness of the pixels by row, 0 to 255.
     *
     * @throws IOException with the file, the problem and legal values
     */
    static int[][] read(byte[] bytes, String file, int mostPixels) throws IOException {
        return new PgmPicture(bytes, file).read(mostPixels);
    }

    private int[][] read(int mostPixels) throws IOException {
        FileLimits.range(file, "the file's size", bytes.length, 8, FileLimits.MAX_PICTURE);
        boolean binary = bytes[1] == '5';
        if (bytes[0] != 'P' || !binary && bytes[1] != '2') {
            throw FileLimits.wrong(file, "the beginning", (char) (bytes[0] & BYTE) + "" + (char) (bytes[1] & BYTE),
                "P5 or P2, a portable grey map");
        }
        at = 2;
        int width = number("the width", 1, LONGEST_SIDE);
        int height = number("the height", 1, LONGEST_SIDE);
        FileLimits.range(file, "the number of pixels", (long) width * height, 1, mostPixels);
        int most = number("the greatest grey", 1, MOST_GREY);
        int size = most > BYTE ? 2 : 1;
        at++;
        if (binary && bytes.length - at < (long) width * height * size) {
            throw FileLimits.wrong(file, "the number of bytes of its pixels", bytes.length - at,
                (long) width * height * size + " for " + width + " x " + height + " pixels: is it cut off?");
        }
        int[][] grey = new int[height][width];
        for (int[] row : grey) {
            for (int k = 0; k < width; k++) {
                row[k] = (binary ? sample(size, most) : number("a grey", 0, most)) * BYTE / most;
            }
        }
        return grey;
    }

    private int sample(int size, int most) throws IOException {
        int value = bytes[at++] & BYTE;
        if (size == 2) {
            value = value << 8 | bytes[at++] & BYTE;
        }
        if (value > most) {
            FileLimits.range(file, "a grey", value, 0, most);
        }
        return value;
    }

    /** Reads a number in text, after blanks and comments. */
    private int number(String what, int low, int high) throws IOException {
        boolean comment = false;
        while (at < bytes.length && (comment || bytes[at] <= ' ' || bytes[at] == '#')) {
            comment = bytes[at] == '#' || comment && bytes[at] != '\n';
            at++;
        }
        long value = 0;
        int from = at;
        while (at < bytes.length && bytes[at] >= '0' && bytes[at] <= '9' && value <= high) {
            value = 10 * value + bytes[at++] - '0';
        }
        if (at == from) {
            throw FileLimits.wrong(file, what, "missing at byte " + at, low + " to " + high);
        }
        FileLimits.range(file, what, value, low, high);
        return (int) value;
    }
}
