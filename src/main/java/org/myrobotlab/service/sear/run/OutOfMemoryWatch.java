// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reports threads of this program that end because memory ran out, including threads of the embedded MyRobotLab that
 * continue with a message. Passes all failures on to the previous handler. Any thread.
 */
final class OutOfMemoryWatch implements Thread.UncaughtExceptionHandler {
    private static final Logger log = LoggerFactory.getLogger(OutOfMemoryWatch.class);

    private final Consumer<OutOfMemoryError> listener;
    private Thread.UncaughtExceptionHandler before;

    OutOfMemoryWatch(Consumer<OutOfMemoryError> listener) {
        this.listener = listener;
    }

    /** Starts watching. */
    synchronized void open() {
        before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler(this);
    }

    /** Stops watching. */
    synchronized void close() {
        if (Thread.getDefaultUncaughtExceptionHandler() == this) {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
    }

    @Override
    public void uncaughtException(Thread thread, Throwable end) {
        if (end instanceof OutOfMemoryError) {
            listener.accept((OutOfMemoryError) end);
        }
        Thread.UncaughtExceptionHandler next;
        synchronized (this) {
            next = before;
        }
        if (next != null) {
            next.uncaughtException(thread, end);
        } else {
            log.error("thread {} has failed", thread.getName(), end);
        }
    }
}
