package org.SEAR.sensors;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** Numbers of readings in words. Any thread. */
final class ReadingWords {
    /** Significant digits of a number of which nothing is known. */
    private static final MathContext DIGITS = new MathContext(6);
    /** More are told by the lowest and the highest. */
    private static final int MANY = 8;

    private ReadingWords() {
    }

    /** Numbers of which nothing is known but their unit. */
    static String of(double[] numbers, String unit) {
        if (numbers.length <= MANY) {
            return withUnit(Arrays.stream(numbers).mapToObj(ReadingWords::plain).collect(Collectors.joining(", ")), unit);
        }
        return withUnit(plain(Arrays.stream(numbers).min().getAsDouble()) + " to " + plain(Arrays.stream(numbers).max().getAsDouble()), unit);
    }

    static String withUnit(String words, String unit) {
        return (words + " " + unit).trim();
    }

    /** With as many digits as six significant ones need: {@code 20.5}. */
    static String plain(double value) {
        if (Double.isNaN(value) || Double.isInfinite(value)) {
            return String.valueOf(value);
        }
        BigDecimal rounded = new BigDecimal(value).round(DIGITS).stripTrailingZeros();
        return Math.abs(rounded.scale()) <= 2 * DIGITS.getPrecision() ? rounded.toPlainString() : rounded.toString();
    }

    /** So many digits behind the point, and never a negative zero. */
    static String fixed(double value, int digits) {
        double per = Math.pow(10, digits);
        return String.format(Locale.ROOT, "%." + digits + "f", Math.rint(value * per) / per + 0.0);
    }

    /** The same of several numbers, {@code 1.00, 2.00}. */
    static String fixed(double[] values, int digits) {
        return Arrays.stream(values).mapToObj(value -> fixed(value, digits)).collect(Collectors.joining(", "));
    }
}
