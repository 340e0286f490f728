// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar.requests;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import org.SEAR.protocol.Uart;

/**
 * Queue of requests to one device. Sends one request at a time and repeats a rejected or lost one. Tries other baud
 * rates if the device never answered. Call under the driver's lock; never blocks. {@link #tick} checks time-outs.
 *
 * @param <R> type of the requests
 */
public final class Requests<R extends DeviceRequest> {
    private static final int TRIES = 3;
    private static final int MAX_WAITING = 100;
    /** Delay of computers and converters in addition to the device's own time, seconds. */
    private static final double ON_THE_WAY = 0.5;
    /** Least pause before a rejected request is repeated, seconds. */
    private static final double AFTER_REFUSAL = 0.03;
    /** Pause after a change of baud rate before the device listens again, seconds. */
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
     * @param bauds the rates that the device may be set to
     * @param forget makes the reader drop an incomplete reply
     * @param sending called with each request before it is sent
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
     * @throws IllegalStateException if too many requests wait
     */
    public void add(R request) {
        if (waiting.size() >= MAX_WAITING) {
            throw new IllegalStateException(MAX_WAITING + " requests already wait for the LIDAR, so " + request.name
                + " was not sent: wait for scans before you request more");
        }
        waiting.add(request);
        next();
    }

    /** Returns the active request; null if there is none. */
    public R current() {
        return current;
    }

    /** Ends the active request and returns it; call {@link #next} to continue. */
    public R answered() {
        R answered = current;
        current = null;
        return answered;
    }

    /** Checks time-outs. */
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

    /** Forgets all requests after the port was closed. */
    public void clear() {
        waiting.clear();
        current = null;
        heard = false;
        notBefore = 0;
        forget.run();
    }

    /** Returns whether no request is active or waiting. */
    public boolean isIdle() {
        return current == null && waiting.isEmpty();
    }

    /** Sets the port to the device's new rate and pauses until the device listens again. */
    public void changeBaud(int baud) {
        line.setBaud(baud);
        forget.run();
        notBefore = line.now() + AFTER_BAUD_CHANGE;
    }

    /** Sends the next request if none is active. */
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
            deadline = line.now() + ON_THE_WAY + current.timeout + Uart.seconds(bytes.length + current.replyLength,
                line.getBaud());
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

    /** Repeats the request at the next baud rate: the device may have been left at another one. */
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

    /** Repeats the active request after a rejection; gives it up after some tries. */
    public void refused(String why) {
        if (tries < TRIES) {
            resend = true;
            deadline = line.now() + AFTER_REFUSAL;
        } else {
            giveUp("the LIDAR refused " + current.name + " " + tries + " times (" + why
                + "): the line has transmission errors");
        }
    }

    /** Called when valid data arrived: the device is present, at this rate. */
    public void hear() {
        if (!heard && baudsTried > 0) {
            events.info("the LIDAR answers at " + line.getBaud() + " baud");
            events.baud(line.getBaud());
        }
        heard = true;
    }
}
