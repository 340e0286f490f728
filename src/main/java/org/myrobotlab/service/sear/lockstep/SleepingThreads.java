package org.myrobotlab.service.sear.lockstep;

import java.util.HashMap;
import java.util.Map;

/** Which threads wait for simulated time, or for the right to make it pass: a callback that does can't end before. Any thread. */
public final class SleepingThreads {
    /** The moment for which those wait who want to go on at once. */
    public static final double NOW = Double.NEGATIVE_INFINITY;

    /** By thread, the simulated time that it waits for. */
    private final Map<Thread, Double> sleeping = new HashMap<>();
    private long woken;

    /** Something that waits, or makes time pass. */
    public interface Work {
        void run() throws InterruptedException;
    }

    /**
     * Does work during which the thread counts as waiting; work within work counts once.
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

    /** How many have waited and gone on: counted in the same moment in which they are asleep no more. */
    synchronized long getWoken() {
        return woken;
    }

    /** Whether a thread waits for time to pass. */
    synchronized boolean sleeps(Thread thread) {
        return sleeping.containsKey(thread);
    }

    /**
     * Whether another thread than the present one has waited long enough and is about to go on.
     *
     * @param now simulated seconds
     */
    public synchronized boolean othersAreDue(double now) {
        return sleeping.entrySet().stream().anyMatch(one -> one.getKey() != Thread.currentThread() && one.getValue() <= now);
    }
}
