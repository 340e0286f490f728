// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.lockstep;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.Test;

/** Threads that wait for simulated time. */
public class SleepingThreadsTest {
    /** More than a busy machine's delay that lock-step once tolerated, 0.5 s. */
    private static final long DELAY_MILLIS = 800;

    private final SleepingThreads threads = new SleepingThreads();
    private final Object monitor = new Object();

    private boolean await(double now) throws InterruptedException {
        synchronized (monitor) {
            return threads.awaitOthers(now, monitor, () -> false, () -> fail("late"));
        }
    }

    private Thread sleeper(double target, CountDownLatch began, CountDownLatch end) {
        Thread thread = new Thread(() -> {
            try {
                threads.whileSleeping(target, () -> {
                    began.countDown();
                    end.await();
                });
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
        thread.start();
        return thread;
    }

    @Test
    public void aDueThreadThatGetsTheProcessorLateIsAwaited() throws Exception {
        CountDownLatch began = new CountDownLatch(1);
        CountDownLatch end = new CountDownLatch(1);
        sleeper(1, began, end);
        began.await();
        assertTrue("not due yet", await(0.9));
        assertEquals(0, threads.getWoken());
        Thread release = new Thread(() -> {
            try {
                assertFalse(end.await(DELAY_MILLIS, TimeUnit.MILLISECONDS));
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            end.countDown();
        });
        release.start();
        assertTrue(await(1));
        assertEquals(1, threads.getWoken());
    }

    @Test
    public void aThreadThatSleepsForNoTimeIsNotAwaitedForever() throws Exception {
        AtomicBoolean on = new AtomicBoolean(true);
        Thread loop = new Thread(() -> {
            while (on.get()) {
                try {
                    threads.whileSleeping(1, Thread::yield);
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        });
        loop.start();
        while (await(1)) {
            Thread.onSpinWait();
        }
        on.set(false);
        loop.join();
        assertTrue(threads.getWoken() > 0);
    }
}
