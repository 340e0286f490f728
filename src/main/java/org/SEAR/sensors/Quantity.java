// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/** A reading of one number, in the unit of its sensor type; NaN after a drop-out. Immutable; any thread. */
public class Quantity implements Reading {
    private static final int UNSAID = -1;

    private final double value;
    private final int digits;

    /** Words show six significant digits. */
    public Quantity(double value) {
        this(value, UNSAID);
    }

    /** @param digits decimals in words */
    public Quantity(double value, int digits) {
        this.value = value;
        this.digits = digits;
    }

    /** Returns the number, in the unit of the sensor type. */
    public final double get() {
        return value;
    }

    @Override
    public double[] numbers() {
        return new double[] {value};
    }

    @Override
    public String words(double[] kept, String unit) {
        return ReadingWords.withUnit(digits == UNSAID ? ReadingWords.plain(kept[0])
            : ReadingWords.fixed(kept[0], digits), unit);
    }

    @Override
    public String toString() {
        return String.valueOf(value);
    }
}
