package org.SEAR.devices;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.DoubleUnaryOperator;

/**
 * The requests to a device that answers one after the other: while it is at one, more wait, and of too many the last are dropped. Simulation thread
 * only.
 *
 * @param <R> what is asked
 */
public final class RequestQueue<R> {
    private static final int MAX_WAITING = 16;

    private final EventQueue events;
    private final DoubleUnaryOperator due;
    private final Server<R> server;
    private final Deque<R> waiting = new ArrayDeque<>();
    private boolean busy;

    /** Does what is asked. */
    public interface Server<R> {
        /** Does it; then, or later, {@link RequestQueue#done} has to be called. */
        void answer(R request, double time);
    }

    /**
     * A queue without requests.
     *
     * @param events of the device
     * @param due from when a request could be served to when it is
     */
    public RequestQueue(EventQueue events, DoubleUnaryOperator due, Server<R> server) {
        this.events = events;
        this.due = due;
        this.server = server;
    }

    /** A request has come whole. */
    public void add(R request, double time) {
        if (waiting.size() < MAX_WAITING) {
            waiting.add(request);
            next(time);
        }
    }

    /** The present request is answered: the next one's turn. */
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

    /** Drops what waits; the present request is still answered. */
    public void dropWaiting() {
        waiting.clear();
    }

    /** Drops everything, as its device's events are. */
    public void clear() {
        waiting.clear();
        busy = false;
    }
}
