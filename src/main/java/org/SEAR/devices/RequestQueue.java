// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.DoubleUnaryOperator;

/**
 * Requests to a device that answers them one at a time. Up to 16 more wait; further requests are dropped. Simulation
 * thread only.
 *
 * @param <R> type of a request
 */
public final class RequestQueue<R> {
    private static final int MAX_WAITING = 16;

    private final EventQueue events;
    private final DoubleUnaryOperator due;
    private final Server<R> server;
    private final Deque<R> waiting = new ArrayDeque<>();
    private boolean busy;

    /** Answers requests. */
    public interface Server<R> {
        /** Answers a request; {@link RequestQueue#done} must follow, then or later. */
        void answer(R request, double time);
    }

    /**
     * Creates an empty queue.
     *
     * @param events of the device
     * @param due maps the earliest time of an answer to its actual time
     */
    public RequestQueue(EventQueue events, DoubleUnaryOperator due, Server<R> server) {
        this.events = events;
        this.due = due;
        this.server = server;
    }

    /** Adds a complete request. */
    public void add(R request, double time) {
        if (waiting.size() < MAX_WAITING) {
            waiting.add(request);
            next(time);
        }
    }

    /** Marks the present request as answered and schedules the next one. */
    public void done(double time) {
        busy = false;
        next(time);
    }

    private void next(double time) {
        if (!busy && !waiting.isEmpty()) {
            busy = true;
            R request = waiting.remove();
            events.at(due.applyAsDouble(time), t -> server.answer(request, t));
        }
    }

    /** Drops the waiting requests; the present request is still answered. */
    public void dropWaiting() {
        waiting.clear();
    }

    /** Drops all requests; the device must clear its events, too. */
    public void clear() {
        waiting.clear();
        busy = false;
    }
}
