// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** Measured values of scenes with their expected values. */
final class Findings {
    private final List<Finding> all = new ArrayList<>();
    private String scene = "";

    /** One measured value. */
    static final class Finding {
        final String scene;
        final String what;
        final double value;
        final double low;
        final double high;
        private String note = "";

        Finding(String scene, String what, double value, double low, double high) {
            this.scene = scene;
            this.what = what;
            this.value = value;
            this.low = low;
            this.high = high;
        }

        boolean holds() {
            return value >= low && value <= high;
        }

        /** Returns a row of the report. */
        String row() {
            String limit = low == Double.NEGATIVE_INFINITY ? "at most " + number(high) : low == high ? number(low)
                : high == Double.POSITIVE_INFINITY ? "at least " + number(low) : number(low) + " to " + number(high);
            return String.format(Locale.ROOT, "%-4s %-46s %-44s %12s   %s%s", holds() ? "ok" : "FAIL", scene, what,
                number(value), limit, note);
        }

        private static String number(double value) {
            return String.format(Locale.ROOT, "%.6g", value).replaceAll("(\\.\\d*?)0+$", "$1").replaceAll("\\.$", "");
        }
    }

    /** Sets the scene of the following values. */
    Findings in(String newScene) {
        scene = newScene;
        return this;
    }

    private void add(String what, double value, double low, double high) {
        all.add(new Finding(scene, what, value, low, high));
    }

    void atMost(String what, double limit, double value) {
        add(what, value, Double.NEGATIVE_INFINITY, limit);
    }

    void atLeast(String what, double limit, double value) {
        add(what, value, limit, Double.POSITIVE_INFINITY);
    }

    void equal(String what, double expected, double value) {
        add(what, value, expected, expected);
    }

    /** @param share largest relative difference from the expected value */
    void within(String what, double expected, double share, double value) {
        double off = Math.abs(expected) * share;
        add(what, value, expected - off, expected + off);
    }

    /** Adds a value with the largest absolute difference from the expected one. */
    void near(String what, double expected, double off, double value) {
        add(what, value, expected - off, expected + off);
    }

    /** Adds a note to the last value. */
    void note(String text) {
        all.get(all.size() - 1).note = text;
    }

    List<Finding> list() {
        return all;
    }

    /** Fails with all values outside their limits. */
    void assertHold() {
        String wrong = all.stream().filter(finding -> !finding.holds()).map(Finding::row)
            .collect(Collectors.joining("\n"));
        assertTrue("nothing was measured", !all.isEmpty());
        assertTrue("\n" + wrong, wrong.isEmpty());
    }
}
