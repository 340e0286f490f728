package org.myrobotlab.service.lidar;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import org.SEAR.protocol.Uart;
import org.SEAR.protocol.lms.Baud;
import org.SEAR.protocol.lms.Command;
import org.SEAR.protocol.lms.Telegram;
import org.SEAR.protocol.lms.TelegramReader;

/**
 * Talks to a SICK LMS2xx: one request at a time, each acknowledged and answered, repeated when refused or lost; looks for the device at other
 * baud rates when it hears nothing. Any thread; never blocks. Time-outs pass when {@link #tick} is called.
 */
final class LmsDriver implements TelegramReader.Listener {
    private static final int TRIES = 3;
    private static final int MOST_WAITING = 100;
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

        /** Seconds for time-outs. */
        double now();
    }

    private final Line line;
    private final DriverEvents events;
    private final Consumer<Telegram> scans;
    private final TelegramReader reader = new TelegramReader(address -> (address & Telegram.FROM_DEVICE) != 0, this);
    private final Deque<LmsRequest> waiting = new ArrayDeque<>();
    private LmsRequest current;
    private int tries;
    private int baudsTried;
    private boolean heard;
    private boolean resend;
    private double deadline;
    private double notBefore;

    /** @param scans takes the B0h telegrams that the device sends by itself */
    LmsDriver(Line line, DriverEvents events, Consumer<Telegram> scans) {
        this.line = line;
        this.events = events;
        this.scans = scans;
    }

    /**
     * Queues a request.
     *
     * @throws IllegalStateException if the device is far behind
     */
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
        reader.accept(bytes);
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
        reader.clear();
    }

    /** Whether nothing is asked or waits. */
    synchronized boolean isIdle() {
        return current == null && waiting.isEmpty();
    }

    /** Follows the device to another rate; it needs a moment before it listens there. */
    void changeBaud(int baud) {
        line.setBaud(baud);
        reader.clear();
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
            byte[] telegram = Telegram.request(current.payload.get()).toBytes();
            deadline = line.now() + ACKNOWLEDGE + current.patience + Uart.seconds(telegram.length + current.replyLength, line.getBaud());
            line.write(telegram);
        } catch (RuntimeException e) {
            giveUp(current.name + " could not be sent: " + e.getMessage());
        }
    }

    private void missed() {
        reader.clear();
        if (tries < TRIES && (heard || baudsTried == 0)) {
            transmit();
        } else if (!heard && baudsTried < Baud.values().length) {
            tryAnotherBaud();
        } else {
            giveUp("no answer to " + current.name + " after " + tries + " tries at " + line.getBaud()
                + " baud: is the LIDAR switched on, and is this its port and baud rate?");
        }
    }

    /** Nothing was ever heard on this connection: the device may have been left at another rate. */
    private void tryAnotherBaud() {
        baudsTried++;
        line.setBaud(Baud.after(line.getBaud()).getRate());
        transmit();
    }

    private void giveUp(String message) {
        current = null;
        waiting.clear();
        events.error(message);
    }

    @Override
    public void onStray(int value) {
        if (current != null && value == Telegram.ACK) {
            hear();
        } else if (current != null && value == Telegram.NAK) {
            hear();
            refused();
        }
    }

    private void refused() {
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
    public void onTelegram(Telegram telegram) {
        int command = telegram.getCommand();
        hear();
        if (current != null && command == current.command.getReply()) {
            LmsRequest answered = current;
            current = null;
            accept(answered.then, telegram);
            sendNext();
        } else if (current != null && command == Command.NOT_PERMITTED) {
            String name = current.name;
            current = null;
            events.error("the LIDAR does not permit " + name + " in its present operating mode");
            sendNext();
        } else if (command == Command.SCAN.getReply()) {
            accept(scans, telegram);
        } else if (command == Command.POWER_ON) {
            events.info("the LIDAR has started: " + LmsReplies.text(telegram));
        }
    }

    private void accept(Consumer<Telegram> taker, Telegram telegram) {
        try {
            taker.accept(telegram);
        } catch (IndexOutOfBoundsException | IllegalArgumentException e) {
            events.error("the LIDAR sent a telegram " + Integer.toHexString(telegram.getCommand()) + "h that makes no sense, " + telegram.size()
                + " bytes: " + e.getMessage());
        }
    }
}
