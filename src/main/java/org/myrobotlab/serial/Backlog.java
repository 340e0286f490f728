package org.myrobotlab.serial;

import java.util.concurrent.locks.LockSupport;
import org.myrobotlab.framework.interfaces.ServiceInterface;

/**
 * Keeps bytes from coming faster than MyRobotLab's messages carry them: its Serial service publishes each byte as a message of its own, and an outbox
 * complains of more than 1024. So bytes go to a service in pieces of {@link #PIECE}, and the next piece waits until few messages wait. Any thread.
 */
public final class Backlog {
    /** Bytes at a time. MyRobotLab's own reader fails on more than 999. */
    public static final int PIECE = 100;

    /** As many messages may wait in an outbox before the next piece. */
    private static final int MAX_MESSAGES = 500;
    private static final long LOOK_NANOS = 50_000;

    private Backlog() {
    }

    /**
     * Whether a service has more messages on their way out than a piece may be added to.
     *
     * @param listener a service, or anything else: false
     */
    public static boolean isLong(Object listener) {
        return listener instanceof ServiceInterface && ((ServiceInterface) listener).getOutbox().isRunning()
            && ((ServiceInterface) listener).getOutbox().size() > MAX_MESSAGES;
    }

    /**
     * Waits until a service has few messages on their way out.
     *
     * @param timeout nanoseconds after which this returns all the same
     */
    public static void await(Object listener, long timeout) {
        long end = System.nanoTime() + timeout;
        while (isLong(listener) && System.nanoTime() < end && !Thread.currentThread().isInterrupted()) {
            LockSupport.parkNanos(LOOK_NANOS);
        }
    }
}
