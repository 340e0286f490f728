package org.SEAR.devices;

import java.util.List;
import org.SEAR.protocol.Uart;

/**
 * The {@link SerialLine} of one device. Both directions carry 10 bits a byte in simulated time. What a device sends waits for the line; a message for
 * which more than {@link #MAX_OUTPUT} bytes wait already is lost whole. What the user's end writes waits too, up to {@link #MAX_WAITING} bytes; what
 * comes on top is lost. Both losses are counted, as by a real UART whose buffer is full.
 */
public final class Cable implements SerialLine {
    /** Bytes of a device's output that wait for the line, as in a real UART's buffer: while more do, what it sends is lost. */
    public static final int MAX_OUTPUT = 4096;
    /** Most bytes from the user's end that wait for their turn. */
    public static final int MAX_WAITING = 1 << 20;
    /** What a byte looks like at the wrong speed. */
    private static final int GARBLE = 0xA5;
    private static final int FIRST_SIZE = 256;
    /** So long after the user's last byte an answer is not kept for the end of a step, s. */
    private static final double CONVERSATION = 0.1;
    /** Meanwhile the device's timers run so often, s. */
    private static final double LOOK = 0.001;
    /** An answer that leaves the line within so long is waited for, s. */
    private static final double SHORT = 0.02;

    private final String objectName;
    private final String objectType;
    private final String uartPort;
    private final String userPort;
    private SerialDevice device;
    private volatile boolean powered = true;
    private Sink sink = bytes -> { };
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
    /** Who has opened the user's end. */
    private volatile Thread opener;
    /** {@link #hostBaud} as it was at the beginning of the step. */
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

    /** Fresh cable, fresh device with its power on. What was written and not yet carried is gone; the user's speed stays. */
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
     * Switches the device's power; what is on the line is gone. What comes for a device without power is gone too. Does nothing if it is so already.
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

    /** What its device is doing, in words: {@link SerialDevice#status}, or that it is off. Simulation thread. */
    public String status() {
        return powered ? device.status() : "off";
    }

    /** {@link SerialDevice#pinStates} of its device; empty while it is off. Simulation thread. */
    public List<PinState> pinStates() {
        return powered ? device.pinStates() : List.of();
    }

    /** Whether its device moves its robot when it is told to, see {@link SerialDevice#takesDriveCommands}. Simulation thread. */
    public boolean takesDriveCommands() {
        return powered && device.takesDriveCommands();
    }

    /** Commands phase: what was written until now is on its way from {@code time} on. */
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
                byte[] larger = toDevice.length < left + incomingCount ? new byte[2 * (left + incomingCount)] : toDevice;
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

    /** How many bytes have been dropped since the last call. */
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

    /** How many bytes of the device's output have been lost since the last call. Simulation thread. */
    public long takeLost() {
        long count = lost;
        lost = 0;
        return count;
    }

    /** Devices phase: bytes arrive and the device's timers run, up to {@code end}. */
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
            if (speed == device.getBaud()) {
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
     * Between two steps: bytes go to and fro, if there are any or the user has written lately. An answer goes out when its last byte has left the
     * line, or at the step's end: each piece would be one more for which a busy processor has to wake two programs. Simulation thread.
     *
     * @param time simulated seconds, never less than before
     * @return when to look again; infinity if nothing was to be done
     */
    public double serviceDevice(double time) {
        if (!hasIncoming && toDeviceFrom == toDeviceEnd && time >= heardAt + CONVERSATION) {
            return Double.POSITIVE_INFINITY;
        }
        accept(time);
        run(time);
        double next = time + LOOK;
        if (toHostFrom < toHostEnd && toHostTimes[toHostEnd - 1] <= time) {
            deliver(time);
        } else if (toHostFrom < toHostEnd && toHostTimes[toHostEnd - 1] < time + SHORT) {
            next = toHostTimes[toHostEnd - 1];
        }
        return toDeviceFrom < toDeviceEnd ? Math.min(next, toDeviceTime + Uart.seconds(toDeviceEnd - toDeviceFrom, speedOfHost())) : next;
    }

    /** Whether the device, which answers at once, has something to answer, or is about to. Any thread. */
    public boolean hasQueries() {
        return device.answersAtOnce() && (hasIncoming || answering || opened && isOpenerThrough());
    }

    /** Whether the user's end was opened while time stands still, by who has still to go on to where he waits. Any thread. */
    public boolean isOpening() {
        return device.answersAtOnce() && opened;
    }

    /** MyRobotLab's Arduino service opens its port, notes the time and waits: what came before that time does not count. */
    private boolean isOpenerThrough() {
        Thread user = opener;
        return user == null || user == Thread.currentThread() || user.getState() == Thread.State.TIMED_WAITING
            || user.getState() == Thread.State.TERMINATED;
    }

    /** Time stands still: what was written arrives, and all that the device has said leaves the line. Simulation thread. */
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

    /** Who is told that something was written. */
    public void setWakeUp(Runnable newWakeUp) {
        wakeUp = newWakeUp;
    }

    /** Its device has understood a command. Simulation thread. */
    public void understood() {
        baudMismatch.understood();
    }

    /**
     * What to tell the user of what the device doesn't understand; null for nothing. Simulation thread.
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

    /** Puts bytes from the device on the line. */
    public void send(byte[] bytes, double time) {
        double byteTime = Uart.seconds(1, device.getBaud());
        if (freeAt - time > Uart.seconds(MAX_OUTPUT, device.getBaud())) {
            lost += bytes.length;
            return;
        }
        if (toHostEnd + bytes.length > toHost.length) {
            makeRoom(bytes.length);
        }
        boolean garbled = speedOfHost() != device.getBaud();
        freeAt = Math.max(freeAt, time);
        for (byte each : bytes) {
            freeAt += byteTime;
            toHost[toHostEnd] = garbled ? (byte) (each ^ GARBLE) : each;
            toHostTimes[toHostEnd++] = freeAt;
        }
    }

    private void makeRoom(int more) {
        int left = toHostEnd - toHostFrom;
        boolean grow = left + more > toHost.length;
        byte[] bytes = grow ? new byte[2 * (left + more)] : toHost;
        double[] times = grow ? new double[2 * (left + more)] : toHostTimes;
        System.arraycopy(toHost, toHostFrom, bytes, 0, left);
        System.arraycopy(toHostTimes, toHostFrom, times, 0, left);
        toHost = bytes;
        toHostTimes = times;
        toHostFrom = 0;
        toHostEnd = left;
    }

    public double freeAt() {
        return freeAt;
    }

    /**
     * Has somebody look at the line from now on. Simulation thread.
     *
     * @param newListener null for nobody
     */
    public void setListener(LineListener newListener) {
        listener = newListener;
        if (listener != null && userBaud != 0) {
            listener.baud(this, userBaud);
        }
    }

    /** Throws away what has not left the line. */
    public void clearOutput() {
        toHostFrom = 0;
        toHostEnd = 0;
        freeAt = 0;
    }

    /** Throws away what has not left the line by {@code time}, but for the byte that is on it then. */
    public void cutOutput(double time) {
        double byteTime = Uart.seconds(1, device.getBaud());
        while (toHostEnd > toHostFrom && toHostTimes[toHostEnd - 1] - byteTime >= time) {
            toHostEnd--;
            freeAt = Math.max(time, toHostEnd > toHostFrom ? toHostTimes[toHostEnd - 1] : time);
        }
    }

    /** Outputs phase: gives the sink what has left the line by {@code end}; it is gone if the last program has just left the user's end. */
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
        toHostFrom += count;
        if (toHostFrom == toHostEnd) {
            toHostFrom = 0;
            toHostEnd = 0;
        }
        if (listener != null) {
            listener.said(this, bytes);
        }
        if (!closed) {
            sink.receive(bytes);
            delivered += count;
        }
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
            throw new IllegalArgumentException("port " + userPort + ": baud is " + baud + ", legal: above 0, or 0 for the device's own");
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
