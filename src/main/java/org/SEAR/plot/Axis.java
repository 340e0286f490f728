package org.SEAR.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** From where to where an axis goes, and where its marks are: at round numbers. Immutable. */
final class Axis {
    private static final double[] STEPS = {1, 2, 5, 10};
    private static final int MARKS = 6;
    /** From here on, up and down, numbers stand with powers of ten. */
    private static final int MAX_DIGITS = 6;
    /** A mark is near at so much of the way to the next one. */
    private static final double NEAR = 0.25;
    private static final double EDGE = 1e-9;

    final double from;
    final double to;
    private final double step;

    /**
     * Around numbers that are not all missing.
     *
     * @param whole whether it begins and ends at marks; otherwise only if they are near
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

    /** Where a value is on the axis: 0 at its beginning, 1 at its end. */
    double share(double value) {
        return (value - from) / (to - from);
    }

    /** The marked numbers in order. */
    List<Double> marks() {
        List<Double> marks = new ArrayList<>();
        for (long i = (long) Math.ceil(from / step - EDGE); i * step <= to + EDGE * step; i++) {
            marks.add(i * step);
        }
        return marks;
    }

    /** A mark in words. */
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
