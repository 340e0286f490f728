// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.scip;

/**
 * Numbers as printable characters: 6 bits each, highest first, plus 30h; {@code 1234} in two characters is {@code CB}.
 * Source: SCIP 2.0 specification, section 6.
 */
public final class Encoding {
    /** Characters per distance in MS and GS. */
    public static final int SHORT = 2;
    /** Characters per distance in MD and GD. */
    public static final int LONG = 3;
    /** Characters per time stamp. */
    public static final int TIME = 4;
    /** Period of time stamps, milliseconds. */
    public static final int TIME_WRAP = 1 << 24;
    private static final int BITS = 6;
    private static final int MASK = 0x3F;
    private static final int OFFSET = 0x30;

    private Encoding() {
    }

    /** Largest number in a number of characters. */
    public static int max(int characters) {
        return (1 << BITS * characters) - 1;
    }

    /**
     * Appends a number.
     *
     * @param value 0 to {@link #max}
     */
    public static void append(StringBuilder out, int value, int characters) {
        for (int shift = BITS * (characters - 1); shift >= 0; shift -= BITS) {
            out.append((char) ((value >> shift & MASK) + OFFSET));
        }
    }

    /**
     * Decodes the number in a text.
     *
     * @param from index of its first character
     * @throws IllegalArgumentException if a character is not one of the 64
     */
    public static int decode(CharSequence text, int from, int characters) {
        int value = 0;
        for (int i = from; i < from + characters; i++) {
            int bits = text.charAt(i) - OFFSET;
            if (bits < 0 || bits > MASK) {
                throw new IllegalArgumentException("character " + (int) text.charAt(i)
                    + " is no encoded number, legal: 48 to 111");
            }
            value = value << BITS | bits;
        }
        return value;
    }
}
