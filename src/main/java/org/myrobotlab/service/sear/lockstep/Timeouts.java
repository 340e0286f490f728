// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.lockstep;

import java.util.concurrent.TimeUnit;

/**
 * Time-outs of lock-step for threads that may hang. On a busy machine a thread may get no processor for many seconds.
 * If time advanced meanwhile, drivers would give up replies in transit.
 */
final class Timeouts {
    /** Real time after which SEAR reports what lock-step waits for, s. */
    static final long WORD = 5;
    /** Real time after which lock-step continues regardless, s. */
    static final long END = 60;

    private Timeouts() {
    }

    static long nanos(long seconds) {
        return TimeUnit.SECONDS.toNanos(seconds);
    }

    static long millis(long seconds) {
        return TimeUnit.SECONDS.toMillis(seconds);
    }

    /** Returns the end of a warning that lock-step waits. */
    static String waits() {
        return ": lock-step waits for it, " + END + " s at most";
    }
}
