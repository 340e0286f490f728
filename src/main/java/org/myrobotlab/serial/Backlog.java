// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.util.concurrent.locks.LockSupport;
import org.myrobotlab.framework.interfaces.ServiceInterface;

/**
 * Limits the rate of bytes to what MyRobotLab's messages carry: its Serial service publishes each byte as a message,
 * and an outbox complains of more than 1024. A service therefore gets bytes in pieces of {@link #PIECE}; the next piece
 * waits until few messages are queued. Any thread.
 */
public final class Backlog {
    /** Size of a piece, bytes. MyRobotLab's own reader fails on more than 999. */
    public static final int PIECE = 100;

    /** Maximum number of queued messages before the next piece. */
    private static final int MAX_MESSAGES = 500;
    private static final long LOOK_NANOS = 50_000;

    private Backlog() {
    }

    /**
     * Whether a service has too many queued messages for the next piece.
     *
     * @param listener a service; other objects give false
     */
    public static boolean isLong(Object listener) {
        return listener instanceof ServiceInterface && ((ServiceInterface) listener).getOutbox().isRunning()
            && ((ServiceInterface) listener).getOutbox().size() > MAX_MESSAGES;
    }

    /**
     * Waits until a service has few queued messages.
     *
     * @param timeout maximum wait, nanoseconds
     */
    public static void await(Object listener, long timeout) {
        long end = System.nanoTime() + timeout;
        while (isLong(listener) && System.nanoTime() < end && !Thread.currentThread().isInterrupted()) {
            LockSupport.parkNanos(LOOK_NANOS);
        }
    }
}
