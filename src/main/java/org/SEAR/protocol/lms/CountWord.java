// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

/**
 * The word before the values of a B0h telegram. Bits 0 to 9: number of values. Bits 11 and 12: first angle of a partial
 * scan, quarters of a degree. Bit 13: partial scan. Bits 14 and 15: unit. Example: 361 values in millimetres are
 * {@code 69 41}. Source: SICK telegram listing, table 7-31. Immutable.
 */
public final class CountWord {
    private static final int COUNT = 0x3FF;
    private static final int QUARTER_SHIFT = 11;
    private static final int QUARTERS = 3;
    private static final int PARTIAL = 1 << 13;
    private static final int UNIT_SHIFT = 14;

    private final int word;

    private CountWord(int word) {
        this.word = word;
    }

    /** Creates the count word of a received word. */
    public static CountWord of(int word) {
        return new CountWord(word);
    }

    /**
     * Count word of a whole scan.
     *
     * @param count 0 to 1023
     * @param unit see {@link Configuration#getUnit}
     */
    public static CountWord whole(int count, int unit) {
        return new CountWord(count | unit << UNIT_SHIFT);
    }

    /**
     * Count word of a partial scan.
     *
     * @param count 0 to 1023
     * @param unit see {@link Configuration#getUnit}
     * @param quarter 0 to 3, quarters of a degree
     */
    public static CountWord partial(int count, int unit, int quarter) {
        return new CountWord(count | unit << UNIT_SHIFT | PARTIAL | quarter << QUARTER_SHIFT);
    }

    /** Returns the word for a telegram. */
    public int toWord() {
        return word;
    }

    /** Number of values. */
    public int getCount() {
        return word & COUNT;
    }

    /** 0 = centimetres, 1 = millimetres. */
    public int getUnit() {
        return word >> UNIT_SHIFT;
    }

    /** Offset of the first value from a whole degree, quarters of a degree. */
    public int getQuarter() {
        return word >> QUARTER_SHIFT & QUARTERS;
    }
}
