// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.lockstep;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * A token that a {@link Fence} sends behind other messages and waits for. Public because Python's callbacks call it.
 * Any thread.
 */
public final class FencePass {
    private final CountDownLatch back = new CountDownLatch(1);
    private volatile Thread handler;

    FencePass() {
    }

    /** Marks the pass as returned. Thread that processes the queue's messages. */
    public static void passed(FencePass pass) {
        pass.handler = Thread.currentThread();
        pass.back.countDown();
    }

    boolean isBack() {
        return back.getCount() == 0;
    }

    boolean await(long millis) throws InterruptedException {
        return back.await(millis, TimeUnit.MILLISECONDS);
    }

    /** Returns the thread that returned the pass; null before. */
    Thread getHandler() {
        return handler;
    }
}
