package org.SEAR.sensors;

/** A reading that is one number, in the unit of its sensor's type; NaN when it dropped out. Immutable, any thread. */
public class Quantity implements Reading {
    private static final int UNSAID = -1;

    private final double value;
    private final int digits;

    /** Told in words with six significant digits. */
    public Quantity(double value) {
        this(value, UNSAID);
    }

    /** @param digits behind the point, in words */
    public Quantity(double value, int digits) {
        this.value = value;
        this.digits = digits;
    }

    /** In the unit of the sensor's type. */
    public final double get() {
        return value;
    }

    @Override
    public double[] numbers() {
        return new double[] {value};
    }

    @Override
    public String words(double[] kept, String unit) {
        return ReadingWords.withUnit(digits == UNSAID ? ReadingWords.plain(kept[0]) : ReadingWords.fixed(kept[0], digits), unit);
    }

    @Override
    public String toString() {
        return String.valueOf(value);
    }
}
