// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.scip;

/**
 * The character after the text of a reply's line: the low 6 bits of the sum of its bytes, plus 30h. In property lines
 * ({@code DMIN:20;4}) a semicolon precedes it and is not counted.
 */
public final class Checksum {
    private static final int MASK = 0x3F;
    private static final int OFFSET = 0x30;
    private static final char SEPARATOR = ';';
    private static final String REMARK = "<-";

    private Checksum() {
    }

    /** Checksum of a text without a separator. */
    public static char of(CharSequence text) {
        return of(text, 0, text.length());
    }

    private static char of(CharSequence text, int from, int to) {
        int sum = 0;
        for (int i = from; i < to; i++) {
            sum += text.charAt(i);
        }
        return (char) ((sum & MASK) + OFFSET);
    }

    /**
     * Returns a line without its checksum and the separator before it. The checksum may include the separator or not.
     * It may also exclude a remark that starts with {@code <-}, as in a UTM-30LX.
     *
     * @return null if the checksum is wrong
     */
    public static String strip(String line) {
        int end = line.length() - 1;
        if (end < 0) {
            return null;
        }
        char sum = line.charAt(end);
        if (sum == of(line, 0, end)) {
            return line.substring(0, end);
        }
        if (end == 0 || line.charAt(end - 1) != SEPARATOR) {
            return null;
        }
        int remark = line.indexOf(REMARK);
        boolean right = sum == of(line, 0, end - 1) || remark >= 0 && sum == of(line, 0, remark);
        return right ? line.substring(0, end - 1) : null;
    }
}
