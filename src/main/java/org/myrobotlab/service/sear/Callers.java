package org.myrobotlab.service.sear;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;

/** Who waits in a call to the simulation now: a callback that asks is about to go on, one that sleeps until time has passed is not. Any thread. */
final class Callers {
    private final AtomicInteger asking = new AtomicInteger();
    private final Set<Thread> sleeping = ConcurrentHashMap.newKeySet();

    void beginAsking() {
        asking.incrementAndGet();
    }

    void endAsking() {
        asking.decrementAndGet();
    }

    /** Whether somebody waits for the answer to a question. */
    boolean areAsking() {
        return asking.get() > 0;
    }

    void beginSleeping() {
        sleeping.add(Thread.currentThread());
    }

    void endSleeping() {
        sleeping.remove(Thread.currentThread());
    }

    /** Whether a thread waits for time to pass. */
    boolean sleeps(Thread thread) {
        return sleeping.contains(thread);
    }
}
