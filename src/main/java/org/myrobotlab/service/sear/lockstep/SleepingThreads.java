// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.lockstep;

import java.util.HashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;

/**
 * Threads that wait for simulated time, or for the right to advance it. A callback on such a thread can't end before.
 * Any thread.
 */
public final class SleepingThreads {
    /** Target of threads that want to continue immediately. */
    public static final double NOW = Double.NEGATIVE_INFINITY;

    private static final long LOOK_MILLIS = 1;
    /** Number of awakenings at one moment of simulated time that identifies a thread with sleeps of zero length. */
    private static final int MOST_WOKEN = 500;

    /** Simulated time that each thread waits for. */
    private final Map<Thread, Double> sleeping = new HashMap<>();
    private long woken;

    /** An action that waits or advances time. */
    public interface Work {
        void run() throws InterruptedException;
    }

    /**
     * Runs an action during which the thread counts as waiting; nested calls count once.
     *
     * @param target simulated seconds that it waits for, or {@link #NOW}
     */
    public void whileSleeping(double target, Work work) throws InterruptedException {
        boolean outermost = add(target);
        try {
            work.run();
        } finally {
            if (outermost) {
                remove();
            }
        }
    }

    private synchronized boolean add(double target) {
        return sleeping.putIfAbsent(Thread.currentThread(), target) == null;
    }

    private synchronized void remove() {
        sleeping.remove(Thread.currentThread());
        woken++;
    }

    /**
     * Returns how many threads have waited and continued; incremented in the same moment in which they stop waiting.
     */
    synchronized long getWoken() {
        return woken;
    }

    /** Returns whether a thread waits for time to pass. */
    synchronized boolean sleeps(Thread thread) {
        return sleeping.containsKey(thread);
    }

    /**
     * Waits until no other thread has waited long enough. Does not depend on the computer's speed: a thread may get the
     * processor late.
     *
     * @param now simulated seconds
     * @param monitor held by the caller; released meanwhile
     * @param ended whether to give up
     * @param late called if a thread does not continue within a minute of real time
     * @return false if it is late, or if threads repeat sleeps of zero length
     */
    public boolean awaitOthers(double now, Object monitor, BooleanSupplier ended, Runnable late)
        throws InterruptedException {
        long before = getWoken();
        long end = System.nanoTime() + Timeouts.nanos(Timeouts.END);
        while (othersAreDue(now) && !ended.getAsBoolean()) {
            if (getWoken() - before > MOST_WOKEN) {
                return false;
            }
            if (System.nanoTime() > end) {
                late.run();
                return false;
            }
            monitor.wait(LOOK_MILLIS);
        }
        return true;
    }

    /** Returns whether a thread other than the present one has waited long enough and is about to continue. */
    private synchronized boolean othersAreDue(double now) {
        return sleeping.entrySet().stream().anyMatch(one -> one.getKey() != Thread.currentThread()
            && one.getValue() <= now);
    }
}
