// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;
import org.myrobotlab.logging.LoggerFactory;
import org.slf4j.Logger;

/**
 * Runs the calls of pages and programs. A call may last as long as a script, so none runs on the threads that serve
 * pages. Any thread.
 */
final class PageCalls {
    /** Limit of parallel calls. */
    static final int MOST = 64;
    static final String FULL = MOST + " calls are running, which is the limit: wait until one has ended";

    private static final Logger LOG = LoggerFactory.getLogger(PageCalls.class);

    private final String name;
    private final ThreadLocal<Boolean> isOwn = new ThreadLocal<>();
    private final AtomicInteger number = new AtomicInteger();
    private final Semaphore free = new Semaphore(MOST);
    private final ExecutorService threads;

    PageCalls(String name) {
        this.name = name;
        threads = Executors.newCachedThreadPool(this::thread);
    }

    private Thread thread(Runnable work) {
        Thread thread = new Thread(() -> {
            isOwn.set(true);
            work.run();
        }, name + " call-" + number.incrementAndGet());
        thread.setDaemon(true);
        return thread;
    }

    /**
     * Reserves one of the places for calls.
     *
     * @return whether one was free; {@link #leave} must follow then
     */
    boolean enter() {
        return free.tryAcquire();
    }

    /** Frees the place. */
    void leave() {
        free.release();
    }

    /** Runs work on its own thread, unless the server has ended. */
    void execute(Runnable work) {
        try {
            threads.execute(work);
        } catch (RejectedExecutionException e) {
            LOG.debug("{} has ended: a call is dropped", name, e);
        }
    }

    /** Cancels all calls, except the call that runs this method. */
    void stop() {
        if (isOwn.get() == null) {
            threads.shutdownNow();
        } else {
            threads.shutdown();
        }
    }
}
