package org.myrobotlab.service.sear.lockstep;

import java.util.concurrent.TimeUnit;

/**
 * How long lock-step waits for what may hang. On a machine that is busy with other programs a thread may have no processor for many seconds; if time
 * went on meanwhile, drivers would give answers up that are on their way.
 */
final class Timeouts {
    /** After so long the user hears for what lock-step waits. Seconds of the computer's time. */
    static final long WORD = 5;
    /** After so long lock-step goes on all the same. Seconds of the computer's time. */
    static final long END = 60;

    private Timeouts() {
    }

    static long nanos(long seconds) {
        return TimeUnit.SECONDS.toNanos(seconds);
    }

    static long millis(long seconds) {
        return TimeUnit.SECONDS.toMillis(seconds);
    }

    /** What lock-step will do, to follow what it waits for in a warning. */
    static String waits() {
        return ": lock-step waits for it, " + END + " s at most";
    }
}
