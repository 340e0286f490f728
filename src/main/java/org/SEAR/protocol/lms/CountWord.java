package org.SEAR.protocol.lms;

/**
 * The word before the values of a B0h telegram: bits 0 to 9 the number of values, 11 and 12 the quarter of a degree at which a partial scan begins,
 * 13 whether it is one, 14 and 15 the unit. Example: 361 values in millimetres are {@code 69 41}.
 * Source: SICK telegram listing, table 7-31. Immutable.
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

    /** As it came. */
    public static CountWord of(int word) {
        return new CountWord(word);
    }

    /**
     * A whole scan.
     *
     * @param count 0 to 1023
     * @param unit see {@link Configuration#getUnit}
     */
    public static CountWord whole(int count, int unit) {
        return new CountWord(count | unit << UNIT_SHIFT);
    }

    /**
     * A partial scan.
     *
     * @param count 0 to 1023
     * @param unit see {@link Configuration#getUnit}
     * @param quarter 0 to 3, quarters of a degree
     */
    public static CountWord partial(int count, int unit, int quarter) {
        return new CountWord(count | unit << UNIT_SHIFT | PARTIAL | quarter << QUARTER_SHIFT);
    }

    /** As it is sent. */
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

    /** Quarters of a degree between a whole degree and the first value. */
    public int getQuarter() {
        return word >> QUARTER_SHIFT & QUARTERS;
    }
}
