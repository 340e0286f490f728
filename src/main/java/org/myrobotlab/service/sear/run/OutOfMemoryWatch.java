package org.myrobotlab.service.sear.run;

import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Hears of threads of this program that end because there is no memory left, and of those of the embedded MyRobotLab that go on with a message
 * instead; other ends go to whoever heard of them before. Any thread.
 */
final class OutOfMemoryWatch implements Thread.UncaughtExceptionHandler {
    private static final Logger log = LoggerFactory.getLogger(OutOfMemoryWatch.class);

    private final Consumer<OutOfMemoryError> listener;
    private Thread.UncaughtExceptionHandler before;

    OutOfMemoryWatch(Consumer<OutOfMemoryError> listener) {
        this.listener = listener;
    }

    /** Begins to watch. */
    synchronized void open() {
        before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler(this);
    }

    /** Ends it. */
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
