package org.SEAR.project.models;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

/**
 * Runs one piece of work of jMonkeyEngine's loaders on a thread of its own and waits for it. The loaders keep scratch variables for each thread and
 * don't give them back when they fail, and a thread has only five; here they go with the thread. Its stack has the same size wherever it is called
 * from, so that a file is too deep everywhere or nowhere; so has its class loader, by which they find files that come with SEAR and which threads of
 * other languages don't have. Any thread may call it.
 */
final class EngineThread {
    /** Bytes of stack. */
    static final long STACK = 1 << 20;

    private EngineThread() { }

    /**
     * What the work returns. An interrupted caller waits on and stays interrupted.
     *
     * @throws ExecutionException with what the work has thrown, errors too
     */
    static <T> T call(Callable<T> work) throws ExecutionException {
        FutureTask<T> task = new FutureTask<>(work);
        Thread thread = new Thread(null, task, "SEAR model loader", STACK);
        thread.setDaemon(true);
        thread.setContextClassLoader(EngineThread.class.getClassLoader());
        thread.start();
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    return task.get();
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
