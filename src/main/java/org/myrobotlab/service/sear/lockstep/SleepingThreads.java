package org.myrobotlab.service.sear.lockstep;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Which threads wait for simulated time, or for the right to make it pass: a callback that does can't end before. Any thread. */
public final class SleepingThreads {
    /** By thread, the simulated time that it waits for. */
    private final Map<Thread, Double> sleeping = new ConcurrentHashMap<>();

    /** Something that waits, or makes time pass. */
    public interface Work {
        void run() throws InterruptedException;
    }

    /**
     * Does work during which the thread counts as waiting; work within work counts once.
     *
     * @param target simulated seconds that it waits for; infinity for something else
     */
    public void whileSleeping(double target, Work work) throws InterruptedException {
        boolean outermost = sleeping.putIfAbsent(Thread.currentThread(), target) == null;
        try {
            work.run();
        } finally {
            if (outermost) {
                sleeping.remove(Thread.currentThread());
            }
        }
    }

    /** Whether a thread waits for time to pass. */
    boolean sleeps(Thread thread) {
        return sleeping.containsKey(thread);
    }

    /**
     * Whether another thread than the present one has waited long enough and is about to go on.
     *
     * @param now simulated seconds
     */
    public boolean othersAreDue(double now) {
        return sleeping.entrySet().stream().anyMatch(one -> one.getKey() != Thread.currentThread() && one.getValue() <= now);
    }
}
