// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.SEAR.files.LongWork;

/**
 * Runs one task of jMonkeyEngine's loaders on a new thread and waits for it. The loaders use thread-local scratch
 * variables, at most five per thread, and do not release them on failure; here they end with the thread. The stack size
 * is the same for every caller, so a deeply nested file always gives the same result. The class loader, by which the
 * loaders find files that come with SEAR, is set too, since threads of other languages lack it. Any thread may call it.
 */
final class EngineThread {
    /** Stack size, bytes. */
    static final long STACK = 1 << 20;

    private EngineThread() { }

    /**
     * Returns the result of the work. Meanwhile the calling thread reports its progress, and an interrupted caller
     * keeps waiting and stays interrupted.
     *
     * @throws ExecutionException with the exception or error of the work
     */
    static <T> T call(Callable<T> work, LongWork progress) throws ExecutionException {
        FutureTask<T> task = new FutureTask<>(work);
        Thread thread = new Thread(null, task, "SEAR model loader", STACK);
        thread.setDaemon(true);
        thread.setContextClassLoader(EngineThread.class.getClassLoader());
        thread.start();
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    return task.get(progress.untilReport(), TimeUnit.NANOSECONDS);
                } catch (TimeoutException e) {
                    progress.report();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
