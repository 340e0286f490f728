// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.math.BigDecimal;

/**
 * Decides when a script has run for too long. On a busy computer a script waits for a processor, so the time by the
 * clock counts only if the script is idle, or far beyond the limit. One thread.
 */
final class TimeLimit {
    /** Ratio of the longest time by the clock to the limit. */
    private static final double CLOCK_FACTOR = 10;
    /** Share of a processor below which a script is idle. A waiting SEAR uses less than 1 %. */
    private static final double IDLE_SHARE = 0.02;

    private final double limit;
    /** Time by the clock, and processor time, at the end of the last interval that was not idle, s. */
    private double busyAt;
    private double computedThen;

    /** @param limit processor time, and idle time, above 0, s */
    TimeLimit(double limit) {
        this.limit = limit;
    }

    /**
     * Takes the present times.
     *
     * @param elapsed time by the clock since the script's start, s
     * @param computed processor time of the script and the processes that it has started, s
     * @return what the script has done for too long; null while it may go on
     */
    String exceeded(double elapsed, double computed) {
        if (computed - computedThen >= IDLE_SHARE * limit) {
            busyAt = elapsed;
            computedThen = computed;
        }
        if (computed > limit) {
            return "it used more than " + text(limit) + " s of processor time";
        }
        if (elapsed - busyAt > limit) {
            return "it did nothing for " + text(limit) + " s by the computer's clock";
        }
        return elapsed <= CLOCK_FACTOR * limit ? null : "it took more than " + text(CLOCK_FACTOR * limit)
            + " s by the computer's clock";
    }

    private static String text(double seconds) {
        return BigDecimal.valueOf(seconds).stripTrailingZeros().toPlainString();
    }
}
