// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

/**
 * Schedules the steps by a clock in nanoseconds. Deadlines follow the clock, not the last step, so short delays are
 * caught up. After a long delay (the machine slept) the schedule restarts. One thread.
 */
final class Pace {
    /** Longest delay that is caught up, ns, unless two steps take longer. */
    private static final long LONGEST_DELAY = 250_000_000L;
    /** Shortest wait between two steps, ns; shorter waits would occupy the processor. */
    private static final long SHORTEST_WAIT = 100_000L;
    private static final double NANOS = 1e9;

    private long deadline;
    private long length = 1;
    private boolean fresh = true;

    /** Makes the next step due immediately and forgets earlier delays. */
    void restart() {
        fresh = true;
    }

    /**
     * Whether the next step is due; if so, moves the deadline on by one step.
     *
     * @param now clock time, ns
     * @param factor simulated seconds per second of the clock; infinity: always due
     */
    boolean isDue(long now, double factor) {
        if (Double.isInfinite(factor)) {
            fresh = true;
            return true;
        }
        length = Math.max(1, (long) (Simulation.STEP * NANOS / factor));
        if (fresh || now - deadline > Math.max(LONGEST_DELAY, 2 * length)) {
            fresh = false;
            deadline = now;
        }
        if (deadline - now > 0) {
            return false;
        }
        deadline += length;
        return true;
    }

    /** Elapsed share of the time until the next step, 1 to 255 of {@link Simulation#PARTS}. */
    int part(long now) {
        double part = Simulation.PARTS * (1 - (deadline - now) / (double) length);
        return (int) Math.max(1, Math.min(Simulation.PARTS - 1, part));
    }

    /** Waiting time, ns, until a part of the step or until the next step, whichever comes first. */
    long waitFor(int part, long now) {
        long left = deadline - now;
        long parts = (long) Math.ceil((Simulation.PARTS - part) * (length / (double) Simulation.PARTS));
        return Math.min(left, Math.max(SHORTEST_WAIT, left - parts));
    }
}
