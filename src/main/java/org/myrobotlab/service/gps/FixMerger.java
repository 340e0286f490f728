// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import java.util.Objects;
import java.util.function.Consumer;

/**
 * Selects one fix for each moment: a receiver reports the same fix in several sentences, in any order. GGA and NAV-PVT
 * rank above GNS, GNS above RMC and GLL. Fixes below the highest rank of the moment before wait until the moment ends,
 * because a fuller one may follow. One thread.
 */
final class FixMerger {
    /** Greatest difference of the times of one moment: some receivers cut, others round the hundredths. Seconds. */
    private static final double ONE_MOMENT = 0.0101;

    private final Consumer<Fix> fixes;
    private Fix last;
    private Fix waiting;
    private String moment;
    /** Highest rank in the moment before. */
    private int expected = FixSentences.GGA_RANK;
    /** Highest rank in the present moment; -1 before the first fix. */
    private int seen = -1;

    /** @param fixes receives one fix for each moment */
    FixMerger(Consumer<Fix> fixes) {
        this.fixes = fixes;
    }

    /** Takes the time of a sentence; another time ends the moment. Null if unknown. */
    void time(String utc) {
        if (isOneMoment(moment, utc)) {
            return;
        }
        moment = utc;
        if (seen >= 0) {
            expected = seen;
            seen = -1;
        }
        Fix late = waiting;
        waiting = null;
        if (late != null) {
            publish(late);
        }
    }

    void accept(Fix fix) {
        time(fix.utc);
        seen = Math.max(seen, fix.rank());
        if (fix.rank() < expected) {
            waiting = waiting == null || fix.rank() > waiting.rank() || fix.hasFix() && !waiting.hasFix()
                ? fix : waiting;
        } else {
            waiting = null;
            publish(fix);
        }
    }

    private void publish(Fix fix) {
        if (last == null || !repeats(fix)) {
            last = fix;
            fixes.accept(fix);
        }
    }

    /** Returns whether another sentence has already reported this moment at least as well. */
    private boolean repeats(Fix fix) {
        boolean other = !fix.source().equals(last.source());
        return fix.utc != null && isOneMoment(last.utc, fix.utc) && (fix.rank() < last.rank()
            || fix.rank() == last.rank() && other && (last.hasFix() || !fix.hasFix()));
    }

    private static boolean isOneMoment(String one, String other) {
        return Objects.equals(one, other) || one != null && other != null && Math.abs(number(one) - number(other))
            < ONE_MOMENT;
    }

    private static double number(String utc) {
        return utc.matches("[0-9]+([.][0-9]*)?") ? Double.parseDouble(utc) : Double.NaN;
    }
}
