// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Range of an axis and its marks at round numbers. Immutable. */
final class Axis {
    private static final double[] STEPS = {1, 2, 5, 10};
    private static final int MARKS = 6;
    /** From this many digits on, up or down, labels use powers of ten. */
    private static final int MAX_DIGITS = 6;
    /** Fraction of a mark's distance to the next one that counts as near. */
    private static final double NEAR = 0.25;
    private static final double EDGE = 1e-9;

    final double from;
    final double to;
    private final double step;

    /**
     * Fits the axis to numbers that are not all missing.
     *
     * @param whole whether both ends are at marks; otherwise only ends near a mark
     */
    Axis(double least, double most, boolean whole) {
        double span = most - least;
        double room = span > 0 ? span : Math.max(Math.abs(most), 1);
        double raw = room / MARKS;
        double power = Math.pow(10, Math.floor(Math.log10(raw)));
        double nice = STEPS[STEPS.length - 1];
        for (int i = STEPS.length - 1; i >= 0; i--) {
            nice = STEPS[i] * power >= raw * (1 - EDGE) ? STEPS[i] : nice;
        }
        step = nice * power;
        double low = span > 0 ? least : least - room / 2;
        double high = span > 0 ? most : most + room / 2;
        double before = Math.floor(low / step + EDGE) * step;
        double after = Math.ceil(high / step - EDGE) * step;
        from = whole || low - before < NEAR * step ? before : low;
        to = whole || after - high < NEAR * step ? after : high;
    }

    /** Returns the position of a value on the axis: 0 at its beginning, 1 at its end. */
    double share(double value) {
        return (value - from) / (to - from);
    }

    /** Returns the marked numbers in order. */
    List<Double> marks() {
        List<Double> marks = new ArrayList<>();
        for (long i = (long) Math.ceil(from / step - EDGE); i * step <= to + EDGE * step; i++) {
            marks.add(i * step);
        }
        return marks;
    }

    /** Returns a mark's label. */
    String label(double mark) {
        if (mark == 0) {
            return "0";
        }
        int digits = (int) -Math.floor(Math.log10(step) + EDGE);
        if (digits > MAX_DIGITS || Math.abs(mark) >= Math.pow(10, MAX_DIGITS + 1)) {
            return String.format(Locale.ROOT, "%.3g", mark);
        }
        return String.format(Locale.ROOT, "%." + Math.max(0, digits) + "f", mark);
    }
}
