// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** Numbers of readings as text. Any thread. */
final class ReadingWords {
    /** Significant digits of a number of unknown precision. */
    private static final MathContext DIGITS = new MathContext(6);
    /** Above this count the text shows only the lowest and highest number. */
    private static final int MANY = 8;

    private ReadingWords() {
    }

    /** Returns numbers of unknown precision with their unit. */
    static String of(double[] numbers, String unit) {
        if (numbers.length <= MANY) {
            return withUnit(Arrays.stream(numbers).mapToObj(ReadingWords::plain)
                .collect(Collectors.joining(", ")), unit);
        }
        return withUnit(plain(Arrays.stream(numbers).min().getAsDouble()) + " to "
            + plain(Arrays.stream(numbers).max().getAsDouble()), unit);
    }

    static String withUnit(String words, String unit) {
        return (words + " " + unit).trim();
    }

    /** Returns the number with up to six significant digits: {@code 20.5}. */
    static String plain(double value) {
        if (Double.isNaN(value) || Double.isInfinite(value)) {
            return String.valueOf(value);
        }
        BigDecimal rounded = new BigDecimal(value).round(DIGITS).stripTrailingZeros();
        return Math.abs(rounded.scale()) <= 2 * DIGITS.getPrecision() ? rounded.toPlainString() : rounded.toString();
    }

    /** Returns a number with fixed decimals, never a negative zero. */
    static String fixed(double value, int digits) {
        double per = Math.pow(10, digits);
        return String.format(Locale.ROOT, "%." + digits + "f", Math.rint(value * per) / per + 0.0);
    }

    /** Returns several numbers with fixed decimals, {@code 1.00, 2.00}. */
    static String fixed(double[] values, int digits) {
        return Arrays.stream(values).mapToObj(value -> fixed(value, digits)).collect(Collectors.joining(", "));
    }
}
