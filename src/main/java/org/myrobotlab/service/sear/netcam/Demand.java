// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import java.util.EnumSet;
import java.util.Set;
import java.util.concurrent.TimeUnit;

/**
 * The clients' demand for pictures. The server's thread records it, the thread that makes pictures waits for it. Any
 * thread.
 */
final class Demand {
    private final Set<Form> forms = EnumSet.noneOf(Form.class);
    private boolean streaming;
    private long tickets;
    private boolean closed;

    /** The demand at one moment. Immutable. */
    static final class Order {
        /** Requested forms of stills. */
        final Set<Form> forms;
        /** Last ticket issued for them. */
        final long ticket;
        /** Whether the stream has viewers. */
        final boolean streaming;

        Order(Set<Form> forms, long ticket, boolean streaming) {
            this.forms = forms;
            this.ticket = ticket;
            this.streaming = streaming;
        }
    }

    /**
     * Requests a still.
     *
     * @return a ticket, larger than all before; the response carries it
     */
    synchronized long ask(Form form) {
        forms.add(form);
        notifyAll();
        return ++tickets;
    }

    /** Sets whether the stream has viewers. */
    synchronized void setStreaming(boolean on) {
        if (on != streaming) {
            streaming = on;
            notifyAll();
        }
    }

    /**
     * Waits for demand.
     *
     * @param pause longest wait, milliseconds, if only the stream has viewers
     * @return null after the close
     */
    synchronized Order await(long pause) throws InterruptedException {
        if (streaming && forms.isEmpty() && !closed) {
            wait(pause);
        }
        while (!closed && forms.isEmpty() && !streaming) {
            wait();
        }
        if (closed) {
            return null;
        }
        Order order = new Order(forms.isEmpty() ? EnumSet.noneOf(Form.class) : EnumSet.copyOf(forms),
            tickets, streaming);
        forms.clear();
        return order;
    }

    /** Waits a number of milliseconds, or until the close. */
    synchronized void rest(long millis) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
        for (long left = millis; left > 0 && !closed; left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime())) {
            wait(left);
        }
    }

    /** Ends all waiting. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }
}
