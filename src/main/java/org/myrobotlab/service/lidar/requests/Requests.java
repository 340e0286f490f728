package org.myrobotlab.service.lidar.requests;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import org.SEAR.protocol.Uart;

/**
 * The requests to one device: one at a time, repeated when refused or lost; looks for the device at other baud rates when it hears nothing. Under its
 * driver's lock; never blocks. Time-outs pass when {@link #tick} is called.
 *
 * @param <R> what is asked
 */
public final class Requests<R extends DeviceRequest> {
    private static final int TRIES = 3;
    private static final int MAX_WAITING = 100;
    /** Computers and converters take this long beside the device's own time. Seconds. */
    private static final double ON_THE_WAY = 0.5;
    /** Least pause before a request is repeated that was refused. Seconds. */
    private static final double AFTER_REFUSAL = 0.03;
    /** Pause after a change of baud rate before the device listens again. Seconds. */
    private static final double AFTER_BAUD_CHANGE = 0.25;

    private final DeviceLine line;
    private final DriverEvents events;
    private final int[] bauds;
    private final Runnable forget;
    private final Consumer<R> sending;
    private final Deque<R> waiting = new ArrayDeque<>();
    private R current;
    private int tries;
    private int baudsTried;
    private boolean heard;
    private boolean resend;
    private double deadline;
    private double notBefore;

    /**
     * @param bauds that the device may be left at
     * @param forget has the reader forget what is unfinished
     * @param sending is told of each request before it is sent
     */
    public Requests(DeviceLine line, DriverEvents events, int[] bauds, Runnable forget, Consumer<R> sending) {
        this.line = line;
        this.events = events;
        this.bauds = bauds.clone();
        this.forget = forget;
        this.sending = sending;
    }

    /**
     * Queues a request.
     *
     * @throws IllegalStateException if the device is far behind
     */
    public void add(R request) {
        if (waiting.size() >= MAX_WAITING) {
            throw new IllegalStateException(MAX_WAITING + " requests wait for the LIDAR's answer already, " + request.name
                + " was not sent: wait for scans before asking for more");
        }
        waiting.add(request);
        next();
    }

    /** The request whose answer is awaited; null if there is none. */
    public R current() {
        return current;
    }

    /** The present request is answered; {@link #next} goes on. */
    public R answered() {
        R answered = current;
        current = null;
        return answered;
    }

    /** Lets time-outs pass. */
    public void tick() {
        if (current == null) {
            next();
        } else if (line.now() >= deadline) {
            if (resend) {
                transmit();
            } else {
                missed();
            }
        }
    }

    /** Forgets all: the port was closed. */
    public void clear() {
        waiting.clear();
        current = null;
        heard = false;
        notBefore = 0;
        forget.run();
    }

    /** Whether nothing is asked or waits. */
    public boolean isIdle() {
        return current == null && waiting.isEmpty();
    }

    /** Follows the device to another rate; it needs a moment before it listens there. */
    public void changeBaud(int baud) {
        line.setBaud(baud);
        forget.run();
        notBefore = line.now() + AFTER_BAUD_CHANGE;
    }

    /** Sends the next request if none is under way. */
    public void next() {
        if (current == null && !waiting.isEmpty() && line.now() >= notBefore) {
            current = waiting.remove();
            tries = 0;
            baudsTried = 0;
            transmit();
        }
    }

    private void transmit() {
        tries++;
        resend = false;
        try {
            byte[] bytes = current.bytes.get();
            deadline = line.now() + ON_THE_WAY + current.timeout + Uart.seconds(bytes.length + current.replyLength, line.getBaud());
            sending.accept(current);
            line.write(bytes);
            if (current.replyLength == 0) {
                notBefore = line.now() + current.timeout;
                current = null;
            }
        } catch (RuntimeException e) {
            giveUp(current.name + " could not be sent: " + e.getMessage());
        }
    }

    private void missed() {
        forget.run();
        if (tries < TRIES && (heard || baudsTried == 0)) {
            transmit();
        } else if (!heard && baudsTried < bauds.length) {
            tryAnotherBaud();
        } else {
            giveUp("no answer to " + current.name + " after " + tries + " tries at " + line.getBaud()
                + " baud: is the LIDAR switched on, and is this its port and baud rate?");
        }
    }

    /** Nothing was ever heard on this connection: the device may have been left at another rate. */
    private void tryAnotherBaud() {
        baudsTried++;
        line.setBaud(baudAfter(line.getBaud()));
        transmit();
    }

    private int baudAfter(int baud) {
        for (int i = 0; i < bauds.length; i++) {
            if (bauds[i] == baud) {
                return bauds[(i + 1) % bauds.length];
            }
        }
        return bauds[0];
    }

    private void giveUp(String message) {
        current = null;
        waiting.clear();
        events.error(message);
    }

    /** The device did not understand the present request: it is repeated, and given up after some tries. */
    public void refused(String why) {
        if (tries < TRIES) {
            resend = true;
            deadline = line.now() + AFTER_REFUSAL;
        } else {
            giveUp("the LIDAR refused " + current.name + " " + tries + " times (" + why + "): the line is disturbed");
        }
    }

    /** Something came that makes sense: the device is there, at this rate. */
    public void hear() {
        if (!heard && baudsTried > 0) {
            events.info("the LIDAR answers at " + line.getBaud() + " baud");
            events.baud(line.getBaud());
        }
        heard = true;
    }
}
