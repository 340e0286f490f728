package org.SEAR.simulator;

/**
 * When the next step is due, by a clock in nanoseconds. It keeps to the clock, not to the last step, so short delays are caught up; after a long one
 * (the machine slept) time goes on from there. One thread.
 */
final class Pace {
    /** A delay longer than this is not caught up, ns. */
    private static final long LONGEST_DELAY = 250_000_000L;
    /** No wait between two steps is shorter, ns: it would be all that the processor does. */
    private static final long SHORTEST_WAIT = 100_000L;
    private static final double NANOS = 1e9;

    private long deadline;
    private long length = 1;
    private boolean fresh = true;

    /** What was before doesn't count: the next step is due at once. */
    void restart() {
        fresh = true;
    }

    /**
     * Whether the next step's time has come; if so, the one after it counts from now on.
     *
     * @param now of the clock
     * @param factor simulated seconds per second of the clock; infinity for always
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

    /** How much of the time until the next step has passed, 1 to 255 of {@link Simulation#PARTS}. */
    int part(long now) {
        double part = Simulation.PARTS * (1 - (deadline - now) / (double) length);
        return (int) Math.max(1, Math.min(Simulation.PARTS - 1, part));
    }

    /** How long to wait for a part of the time until the next step, or for that step, ns. */
    long waitFor(int part, long now) {
        long left = deadline - now;
        long parts = (long) Math.ceil((Simulation.PARTS - part) * (length / (double) Simulation.PARTS));
        return Math.min(left, Math.max(SHORTEST_WAIT, left - parts));
    }
}
