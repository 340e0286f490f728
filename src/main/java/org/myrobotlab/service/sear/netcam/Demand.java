package org.myrobotlab.service.sear.netcam;

import java.util.EnumSet;
import java.util.Set;
import java.util.concurrent.TimeUnit;

/** What clients wait for: those who serve them say it, who has pictures made hears it. Any thread. */
final class Demand {
    private final Set<Form> forms = EnumSet.noneOf(Form.class);
    private boolean streaming;
    private long tickets;
    private boolean closed;

    /** What is wanted at one moment. Immutable. */
    static final class Order {
        /** Stills that are waited for. */
        final Set<Form> forms;
        /** The last ticket that was given for them. */
        final long ticket;
        /** Whether somebody looks at the stream. */
        final boolean streaming;

        Order(Set<Form> forms, long ticket, boolean streaming) {
            this.forms = forms;
            this.ticket = ticket;
            this.streaming = streaming;
        }
    }

    /**
     * Somebody wants a still.
     *
     * @return a number, larger than all before, which is told when it is there
     */
    synchronized long ask(Form form) {
        forms.add(form);
        notifyAll();
        return ++tickets;
    }

    /** Whether somebody looks at the stream. */
    synchronized void setStreaming(boolean on) {
        if (on != streaming) {
            streaming = on;
            notifyAll();
        }
    }

    /**
     * Waits until something is wanted.
     *
     * @param pause milliseconds after which it comes back if all that is wanted is the stream
     * @return null when there will be nothing more
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
        Order order = new Order(forms.isEmpty() ? EnumSet.noneOf(Form.class) : EnumSet.copyOf(forms), tickets, streaming);
        forms.clear();
        return order;
    }

    /** Waits so many milliseconds, or until there will be nothing more. */
    synchronized void rest(long millis) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
        for (long left = millis; left > 0 && !closed; left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime())) {
            wait(left);
        }
    }

    /** There will be nothing more. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }
}
