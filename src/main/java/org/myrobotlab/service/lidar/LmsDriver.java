package org.myrobotlab.service.lidar;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.function.Consumer;

/**
 * Talks to a SICK LMS2xx: one request at a time, each acknowledged and answered, repeated when refused or lost; looks for the device at other
 * baud rates when it hears nothing. Any thread; never blocks. Time-outs pass when {@link #tick} is called.
 */
final class LmsDriver implements LmsFramer.Sink {
    /** Baud rates of the device and the second byte of their telegram {@code 20 xx}. */
    static final int[][] BAUDS = {{9600, 0x42}, {19200, 0x41}, {38400, 0x40}, {500000, 0x48}};

    private static final int TRIES = 3;
    private static final int MOST_WAITING = 100;
    private static final double BITS_PER_BYTE = 10;
    /** The device acknowledges within 60 ms; computers and converters take longer than that. Seconds. */
    private static final double ACKNOWLEDGE = 0.5;
    /** Least pause before a repeat after a NAK (telegram listing, chapter 4). Seconds. */
    private static final double AFTER_NAK = 0.03;
    /** Pause after a change of baud rate before the device listens again. Seconds. */
    private static final double AFTER_BAUD_CHANGE = 0.25;

    /** The serial port. */
    interface Line {
        void write(byte[] bytes);

        void setBaud(int baud);

        int getBaud();

        /** Seconds by the port's clock. */
        double now();
    }

    /** Whoever wants to know. */
    interface Events {
        /** @param body command, data, status of a B0h telegram */
        void scan(byte[] body);

        /** The device was found at another rate than the port was opened with; the port is at that rate now. */
        void baud(int baud);

        void error(String message);

        void info(String message);
    }

    private final Line line;
    private final Events events;
    private final LmsFramer framer = new LmsFramer();
    private final Deque<LmsRequest> waiting = new ArrayDeque<>();
    private LmsRequest current;
    private int tries;
    private int baudsTried;
    private boolean heard;
    private boolean resend;
    private double deadline;
    private double notBefore;

    LmsDriver(Line line, Events events) {
        this.line = line;
        this.events = events;
    }

    /** Queues a request. @throws IllegalStateException if the device is far behind */
    synchronized void ask(LmsRequest request) {
        if (waiting.size() >= MOST_WAITING) {
            throw new IllegalStateException(MOST_WAITING + " requests wait for the LIDAR's answer already, " + request.name
                + " was not sent: wait for scans before asking for more");
        }
        waiting.add(request);
        sendNext();
    }

    /** Bytes from the device. */
    synchronized void receive(byte[] bytes) {
        framer.feed(bytes, this);
    }

    /** Lets time-outs pass. */
    synchronized void tick() {
        if (current == null) {
            sendNext();
        } else if (line.now() >= deadline) {
            if (resend) {
                transmit();
            } else {
                missed();
            }
        }
    }

    /** Forgets all requests: the port was closed. */
    synchronized void clear() {
        waiting.clear();
        current = null;
        heard = false;
        notBefore = 0;
        framer.reset();
    }

    /** Whether nothing is asked or waits. */
    synchronized boolean isIdle() {
        return current == null && waiting.isEmpty();
    }

    /** Follows the device to another rate; it needs a moment before it listens there. */
    void changeBaud(int baud) {
        line.setBaud(baud);
        framer.reset();
        notBefore = line.now() + AFTER_BAUD_CHANGE;
    }

    private void sendNext() {
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
            byte[] telegram = LmsTelegram.frame(current.body.get());
            deadline = line.now() + ACKNOWLEDGE + current.patience + (telegram.length + current.replyLength) * BITS_PER_BYTE / line.getBaud();
            line.write(telegram);
        } catch (RuntimeException e) {
            giveUp(current.name + " could not be sent: " + e.getMessage());
        }
    }

    private void missed() {
        framer.reset();
        if (tries < TRIES && (heard || baudsTried == 0)) {
            transmit();
        } else if (!heard && baudsTried < BAUDS.length) {
            tryAnotherBaud();
        } else {
            giveUp("no answer to " + current.name + " after " + tries + " tries at " + line.getBaud()
                + " baud: is the LIDAR switched on, and is this its port and baud rate?");
        }
    }

    /** Nothing was ever heard on this connection: the device may have been left at another rate. */
    private void tryAnotherBaud() {
        int index = 0;
        while (BAUDS[index][0] != line.getBaud() && index < BAUDS.length - 1) {
            index++;
        }
        baudsTried++;
        line.setBaud(BAUDS[(index + 1) % BAUDS.length][0]);
        transmit();
    }

    private void giveUp(String message) {
        current = null;
        waiting.clear();
        events.error(message);
    }

    @Override
    public void acknowledged() {
        if (current != null) {
            hear();
        }
    }

    @Override
    public void refused() {
        if (current == null) {
            return;
        }
        hear();
        if (tries < TRIES) {
            resend = true;
            deadline = line.now() + AFTER_NAK;
        } else {
            giveUp("the LIDAR refused " + current.name + " " + tries + " times (NAK): the line is disturbed");
        }
    }

    private void hear() {
        if (!heard && baudsTried > 0) {
            events.info("the LIDAR answers at " + line.getBaud() + " baud");
            events.baud(line.getBaud());
        }
        heard = true;
    }

    @Override
    public void telegram(byte[] body) {
        int command = body[0] & 0xFF;
        hear();
        if (current != null && command == current.reply) {
            LmsRequest answered = current;
            current = null;
            accept(answered.then, body);
            sendNext();
        } else if (current != null && command == LmsTelegram.NOT_PERMITTED) {
            String name = current.name;
            current = null;
            events.error("the LIDAR does not permit " + name + " in its present operating mode");
            sendNext();
        } else if (command == LmsTelegram.SCAN_REPLY) {
            accept(events::scan, body);
        } else if (command == LmsTelegram.POWER_ON) {
            events.info("the LIDAR has started: " + LmsReplies.text(body));
        }
    }

    private void accept(Consumer<byte[]> taker, byte[] body) {
        try {
            taker.accept(body);
        } catch (IndexOutOfBoundsException | IllegalArgumentException e) {
            events.error("the LIDAR sent a telegram " + Integer.toHexString(body[0] & 0xFF) + "h that makes no sense, " + body.length + " bytes: "
                + Arrays.toString(Arrays.copyOf(body, Math.min(body.length, 8))));
        }
    }
}
