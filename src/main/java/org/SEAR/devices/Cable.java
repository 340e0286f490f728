// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.util.List;
import org.SEAR.protocol.Uart;

/**
 * The {@link SerialLine} of one device. Both directions carry 10 bits per byte in simulated time. A device's message
 * waits for the line; it is lost whole if more than {@link #MAX_OUTPUT} bytes wait already. Host bytes wait, too, up to
 * {@link #MAX_WAITING}; further bytes are lost. Both losses are counted, as by a real UART with a full buffer.
 */
public final class Cable implements SerialLine {
    /** Size of the output buffer, bytes: while more wait, the device's messages are lost. */
    public static final int MAX_OUTPUT = 4096;
    /** Size of the input buffer for bytes from the host. */
    public static final int MAX_WAITING = 1 << 20;
    /** Mask that distorts a byte sent at the wrong baud rate. */
    private static final int GARBLE = 0xA5;
    private static final int FIRST_SIZE = 256;
    private static final int[] NO_START = {};
    private static final int[] ONE_START = {0};
    /** For this long after the host's last byte, replies leave at once, not at the end of the step, s. */
    private static final double CONVERSATION = 0.1;
    /** Interval of the device's timers during that time, s. */
    private static final double LOOK = 0.001;
    /** Longest wait, s, for a reply that is still leaving the line. */
    private static final double SHORT = 0.02;

    private final String objectName;
    private final String objectType;
    private final String uartPort;
    private final String userPort;
    private SerialDevice device;
    private volatile boolean powered = true;
    private Sink sink = (bytes, starts) -> { };
    private LineListener listener;
    private final Object lock = new Object();
    private byte[] incoming = new byte[FIRST_SIZE];
    private int incomingCount;
    private volatile boolean hasIncoming;
    private volatile Runnable wakeUp = () -> { };
    private volatile boolean answering;
    private double heardAt = Double.NEGATIVE_INFINITY;
    private volatile int hostBaud;
    private volatile boolean opened;
    /** Thread that opened the host port. */
    private volatile Thread opener;
    /** {@link #hostBaud} at the beginning of the step. */
    private int userBaud;
    private volatile boolean closed;
    private volatile int deviceBaud;
    private volatile long written;
    private volatile long dropped;
    private volatile int waiting;
    private volatile long delivered;
    private long lost;
    private byte[] toDevice = new byte[FIRST_SIZE];
    private int toDeviceFrom;
    private int toDeviceEnd;
    private double toDeviceTime;
    private byte[] toHost = new byte[FIRST_SIZE];
    private double[] toHostTimes = new double[FIRST_SIZE];
    /** Which bytes to the host begin a message. */
    private boolean[] toHostStarts = new boolean[FIRST_SIZE];
    private int toHostFrom;
    private int toHostEnd;
    private double freeAt;
    private final BaudMismatch baudMismatch = new BaudMismatch();

    public Cable(String objectName, String objectType, String uartPort, String userPort) {
        this.objectName = objectName;
        this.objectType = objectType;
        this.uartPort = uartPort;
        this.userPort = userPort;
    }

    public void attach(SerialDevice newDevice) {
        device = newDevice;
        deviceBaud = newDevice.getBaud();
    }

    /** Restarts cable and device, as after power-on. Bytes on the line are lost; the host's baud rate stays. */
    public void restart() {
        clear();
        baudMismatch.begin();
        powered = true;
        device.reset();
        deviceBaud = device.getBaud();
    }

    private void clear() {
        synchronized (lock) {
            incomingCount = 0;
            hasIncoming = false;
        }
        toDeviceFrom = 0;
        toDeviceEnd = 0;
        toDeviceTime = 0;
        heardAt = Double.NEGATIVE_INFINITY;
        waiting = 0;
        clearOutput();
    }

    /**
     * Switches the device's power; bytes on the line are lost, and so are bytes for a device without power. Does
     * nothing if the power is in that state already.
     *
     * @param time simulated seconds
     */
    public void setPowered(boolean on, double time) {
        if (on == powered) {
            return;
        }
        clear();
        powered = on;
        if (on) {
            device.powerOn(time);
            deviceBaud = device.getBaud();
        } else {
            device.powerOff();
        }
    }

    /** Status of the device, see {@link SerialDevice#status}, or "off". Simulation thread. */
    public String status() {
        return powered ? device.status() : "off";
    }

    /** {@link SerialDevice#pinStates} of its device; empty while it is off. Simulation thread. */
    public List<PinState> pinStates() {
        return powered ? device.pinStates() : List.of();
    }

    /**
     * Whether the device accepts drive commands now, see {@link SerialDevice#takesDriveCommands}. Simulation thread.
     */
    public boolean takesDriveCommands() {
        return powered && device.takesDriveCommands();
    }

    /** Commands phase: bytes written until now start at {@code time}. */
    public void accept(double time) {
        accept(time, false);
    }

    private void accept(double time, boolean standing) {
        if (userBaud != hostBaud) {
            userBaud = hostBaud;
            if (listener != null) {
                listener.baud(this, userBaud);
            }
        }
        if (closed) {
            closed = false;
            if (listener != null) {
                listener.lineClosed(this);
            }
            if (powered) {
                device.portClosed(time);
            }
        }
        if (opened) {
            opened = false;
            opener = null;
            baudMismatch.begin();
            if (listener != null) {
                listener.opened(this);
            }
            if (powered) {
                open(time, standing);
            }
        }
        if (!hasIncoming) {
            return;
        }
        heardAt = time;
        synchronized (lock) {
            if (toDeviceFrom == toDeviceEnd) {
                toDeviceFrom = 0;
                toDeviceEnd = 0;
                toDeviceTime = time;
            }
            int left = toDeviceEnd - toDeviceFrom;
            if (toDevice.length - toDeviceEnd < incomingCount) {
                byte[] larger = toDevice.length < left + incomingCount
                    ? new byte[2 * (left + incomingCount)] : toDevice;
                System.arraycopy(toDevice, toDeviceFrom, larger, 0, left);
                toDevice = larger;
                toDeviceFrom = 0;
                toDeviceEnd = left;
            }
            System.arraycopy(incoming, 0, toDevice, toDeviceEnd, incomingCount);
            if (listener != null) {
                listener.heard(this, incoming, incomingCount);
            }
            toDeviceEnd += incomingCount;
            incomingCount = 0;
            hasIncoming = false;
            waiting = toDeviceEnd - toDeviceFrom;
        }
    }

    private void open(double time, boolean standing) {
        if (standing) {
            device.openedAtOnce(time);
        } else {
            device.opened(time);
        }
    }

    /** Returns the number of host bytes dropped since the last call. */
    public long takeDropped() {
        if (dropped == 0) {
            return 0;
        }
        synchronized (lock) {
            long count = dropped;
            dropped = 0;
            return count;
        }
    }

    /** Returns the number of device bytes lost since the last call. Simulation thread. */
    public long takeLost() {
        long count = lost;
        lost = 0;
        return count;
    }

    /** Devices phase: delivers bytes to the device and runs its timers, up to {@code end}. */
    public void run(double end) {
        run(end, 1);
    }

    /** @param slowness 1, or 0 for a line on which bytes take no time */
    private void run(double end, int slowness) {
        while (toDeviceFrom < toDeviceEnd) {
            int speed = speedOfHost();
            double arrival = toDeviceTime + slowness * Uart.seconds(1, speed);
            if (arrival > end) {
                break;
            }
            toDeviceTime = arrival;
            int value = toDevice[toDeviceFrom++] & 0xFF;
            if (!powered) {
                continue;
            }
            device.advance(arrival);
            if (device.matches(speed)) {
                if (!device.isStarting()) {
                    baudMismatch.heard(value, arrival);
                }
                device.receive(value, arrival);
            } else {
                baudMismatch.garbled(speed);
                device.receiveGarbage(arrival);
            }
        }
        if (waiting > 0) {
            waiting = toDeviceEnd - toDeviceFrom;
        }
        if (powered) {
            device.advance(end);
        }
        deviceBaud = device.getBaud();
    }

    /**
     * Carries bytes in both directions between two steps, if there are any, the host has written lately, or the
     * device's next action is due. A reply goes out when its last byte has left the line, or at the step's end: each
     * further piece would wake two programs on a busy processor. Simulation thread.
     *
     * @param time simulated seconds, never decreasing
     * @return simulated time of the next service, s; infinity if there was nothing to do
     */
    public double serviceDevice(double time) {
        boolean talks = hasIncoming || toDeviceFrom < toDeviceEnd || time < heardAt + CONVERSATION;
        if (!talks && nextAction() > time) {
            return Double.POSITIVE_INFINITY;
        }
        accept(time);
        run(time);
        double next = talks ? time + LOOK : Double.POSITIVE_INFINITY;
        if (toHostFrom < toHostEnd && toHostTimes[toHostEnd - 1] <= time) {
            deliver(time);
        } else if (toHostFrom < toHostEnd && toHostTimes[toHostEnd - 1] < time + SHORT) {
            next = toHostTimes[toHostEnd - 1];
        }
        return toDeviceFrom < toDeviceEnd
            ? Math.min(next, toDeviceTime + Uart.seconds(toDeviceEnd - toDeviceFrom, speedOfHost())) : next;
    }

    /**
     * Time at which the device acts next, or its waiting messages have left the line, see
     * {@link SerialDevice#nextAction}; simulated seconds, infinity without any.
     */
    public double nextAction() {
        double next = powered ? device.nextAction() : Double.POSITIVE_INFINITY;
        return next < Double.POSITIVE_INFINITY && toHostFrom < toHostEnd
            ? Math.min(next, toHostTimes[toHostEnd - 1]) : next;
    }

    /** Whether the device answers at once and has input, or will have it. Any thread. */
    public boolean hasQueries() {
        return device.answersAtOnce() && (hasIncoming || answering || opened && isOpenerThrough());
    }

    /**
     * Whether the host port was opened while time stands still and its opener does not wait for a reply yet. Any
     * thread.
     */
    public boolean isOpening() {
        return device.answersAtOnce() && opened;
    }

    /** MyRobotLab's Arduino service opens its port, notes the time and waits; it ignores earlier replies. */
    private boolean isOpenerThrough() {
        Thread user = opener;
        return user == null || user == Thread.currentThread() || user.getState() == Thread.State.TIMED_WAITING
            || user.getState() == Thread.State.TERMINATED;
    }

    /** Carries all bytes while time stands still: input arrives, and all output leaves the line. Simulation thread. */
    public void answer(double time) {
        answering = true;
        try {
            accept(time, true);
            run(time, 0);
            deliver(Double.POSITIVE_INFINITY);
            freeAt = Math.min(freeAt, time);
        } finally {
            answering = false;
        }
    }

    /** Sets the callback that runs when the host has written. */
    public void setWakeUp(Runnable newWakeUp) {
        wakeUp = newWakeUp;
    }

    /** Notes that the device has understood a command. Simulation thread. */
    public void understood() {
        baudMismatch.understood();
    }

    /**
     * Warning about bytes that the device does not understand, see {@link BaudMismatch}; null for none. Simulation
     * thread.
     *
     * @param time simulated seconds
     */
    public String complaint(double time) {
        return baudMismatch.complaint(device.title(), device.getBaud(), time);
    }

    private int speedOfHost() {
        int speed = userBaud;
        return speed > 0 && !device.hearsEveryBaud() ? speed : device.getBaud();
    }

    /** Puts a message from the device on the line. */
    public void send(byte[] bytes, double time) {
        double byteTime = Uart.seconds(1, device.getBaud());
        if (freeAt - time > Uart.seconds(MAX_OUTPUT, device.getBaud())) {
            lost += bytes.length;
            return;
        }
        if (toHostEnd + bytes.length > toHost.length) {
            makeRoom(bytes.length);
        }
        boolean garbled = !device.matches(speedOfHost());
        freeAt = Math.max(freeAt, time);
        int start = toHostEnd;
        for (byte each : bytes) {
            freeAt += byteTime;
            toHost[toHostEnd] = garbled ? (byte) (each ^ GARBLE) : each;
            toHostStarts[toHostEnd] = toHostEnd == start;
            toHostTimes[toHostEnd++] = freeAt;
        }
    }

    private void makeRoom(int more) {
        int left = toHostEnd - toHostFrom;
        boolean grow = left + more > toHost.length;
        byte[] bytes = grow ? new byte[2 * (left + more)] : toHost;
        double[] times = grow ? new double[2 * (left + more)] : toHostTimes;
        boolean[] starts = grow ? new boolean[2 * (left + more)] : toHostStarts;
        System.arraycopy(toHost, toHostFrom, bytes, 0, left);
        System.arraycopy(toHostTimes, toHostFrom, times, 0, left);
        System.arraycopy(toHostStarts, toHostFrom, starts, 0, left);
        toHost = bytes;
        toHostTimes = times;
        toHostStarts = starts;
        toHostFrom = 0;
        toHostEnd = left;
    }

    public double freeAt() {
        return freeAt;
    }

    /**
     * Sets the listener of the line. Simulation thread.
     *
     * @param newListener null for none
     */
    public void setListener(LineListener newListener) {
        listener = newListener;
        if (listener != null && userBaud != 0) {
            listener.baud(this, userBaud);
        }
    }

    /** Discards all bytes that have not left the line. */
    public void clearOutput() {
        toHostFrom = 0;
        toHostEnd = 0;
        freeAt = 0;
    }

    /** Discards the bytes that have not left the line by {@code time}, except the byte being sent then. */
    public void cutOutput(double time) {
        double byteTime = Uart.seconds(1, device.getBaud());
        while (toHostEnd > toHostFrom && toHostTimes[toHostEnd - 1] - byteTime >= time) {
            toHostEnd--;
            freeAt = Math.max(time, toHostEnd > toHostFrom ? toHostTimes[toHostEnd - 1] : time);
        }
    }

    /**
     * Outputs phase: gives the sink the bytes that have left the line by {@code end}. They are lost if the last program
     * has just closed the host port.
     */
    public void deliver(double end) {
        int count = 0;
        while (toHostFrom + count < toHostEnd && toHostTimes[toHostFrom + count] <= end) {
            count++;
        }
        if (count == 0) {
            return;
        }
        byte[] bytes = new byte[count];
        System.arraycopy(toHost, toHostFrom, bytes, 0, count);
        int[] starts = starts(count);
        toHostFrom += count;
        if (toHostFrom == toHostEnd) {
            toHostFrom = 0;
            toHostEnd = 0;
        }
        if (listener != null) {
            listener.said(this, bytes);
        }
        if (!closed) {
            sink.receive(bytes, starts);
            delivered += count;
        }
    }

    /** Returns the indices of the starts of messages among the next bytes to the host. */
    private int[] starts(int count) {
        int number = 0;
        for (int i = 0; i < count; i++) {
            number += toHostStarts[toHostFrom + i] ? 1 : 0;
        }
        if (number <= 1 && toHostStarts[toHostFrom] == (number == 1)) {
            return number == 0 ? NO_START : ONE_START;
        }
        int[] starts = new int[number];
        for (int i = 0, found = 0; i < count; i++) {
            if (toHostStarts[toHostFrom + i]) {
                starts[found++] = i;
            }
        }
        return starts;
    }

    @Override
    public String getObjectName() {
        return objectName;
    }

    @Override
    public String getObjectType() {
        return objectType;
    }

    @Override
    public String getUartPort() {
        return uartPort;
    }

    @Override
    public String getUserPort() {
        return userPort;
    }

    @Override
    public boolean isPowered() {
        return powered;
    }

    @Override
    public int getDeviceBaud() {
        return deviceBaud;
    }

    @Override
    public boolean hearsEveryBaud() {
        return device.hearsEveryBaud();
    }

    @Override
    public void open() {
        opener = Thread.currentThread();
        opened = true;
        wakeUp.run();
    }

    @Override
    public void hangUp() {
        closed = true;
    }

    @Override
    public void setHostBaud(int baud) {
        if (baud < 0) {
            throw new IllegalArgumentException("port " + userPort + ": baud is " + baud
                + ", legal: 0 (the device's own) or more");
        }
        hostBaud = baud;
    }

    @Override
    public void write(byte[] bytes) {
        synchronized (lock) {
            int taken = Math.min(bytes.length, Math.max(0, MAX_WAITING - waiting - incomingCount));
            if (incomingCount + taken > incoming.length) {
                byte[] larger = new byte[Math.min(MAX_WAITING, 2 * (incomingCount + taken))];
                System.arraycopy(incoming, 0, larger, 0, incomingCount);
                incoming = larger;
            }
            System.arraycopy(bytes, 0, incoming, incomingCount, taken);
            incomingCount += taken;
            dropped += bytes.length - taken;
            written += taken;
            hasIncoming = incomingCount > 0;
        }
        wakeUp.run();
    }

    @Override
    public int getWaiting() {
        synchronized (lock) {
            return incomingCount + waiting;
        }
    }

    @Override
    public void setSink(Sink newSink) {
        sink = newSink;
    }

    @Override
    public long getWritten() {
        return written;
    }

    @Override
    public long getDelivered() {
        return delivered;
    }
}
