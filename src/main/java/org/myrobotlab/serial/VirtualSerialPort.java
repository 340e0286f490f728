// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.IntConsumer;
import java.util.function.IntSupplier;
import java.util.function.LongConsumer;
import org.SEAR.protocol.Uart;
import org.myrobotlab.service.interfaces.SerialDataListener;

/**
 * A serial port in memory. {@link #makeNullModem} joins two of them like a null-modem cable joins two real ports.
 * {@link SerialDeviceFactory#add} makes them known, so that MyRobotLab's Serial service opens them by name like any
 * other port.
 *
 * <pre>
 * uart = VirtualSerialPort("/dev/my_Controller01")
 * user = VirtualSerialPort("/dev/user_CONTROLLER_01")
 * VirtualSerialPort.makeNullModem(uart, user)
 * SerialDeviceFactory.add(uart)
 * SerialDeviceFactory.add(user)
 * </pre>
 *
 * <p>Each byte takes 10 bits of time at the slower end's baud rate, by {@link PortClock}. Bytes for a closed port are
 * lost, as on a real cable. Any thread may call. The port's own reader thread, which lives while the port is open,
 * calls the listeners.
 */
public class VirtualSerialPort extends Port {
    /** Slowest and fastest baud rate, bits per second. */
    public static final int LOWEST_BAUD = 50;
    public static final int HIGHEST_BAUD = 4_000_000;
    /** Size of the buffer, bytes; a writer with {@link #awaitRoom} waits when it is full. */
    public static final int BUFFER = 4096;

    /** Interval of checks for room, milliseconds. */
    private static final long LOOK_FOR_ROOM = 10;
    private static final String WAY_OUT = "disconnect() there first";
    private static final int DEFAULT_BAUD = 115200;
    /** Maximum wait of the reader thread for a service with too many queued messages, ns. */
    private static final long TIMEOUT = TimeUnit.SECONDS.toNanos(1);

    private final Object lock = new Object();
    private final ByteQueue incoming = new ByteQueue();
    private volatile VirtualSerialPort peer;
    private volatile boolean paced = true;
    private volatile boolean opened;
    private volatile String owner;
    private volatile String wayOut = WAY_OUT;
    private volatile IntConsumer baudListener = baud -> { };
    private volatile Runnable openListener = () -> { };
    private volatile LongConsumer handedHook = total -> { };
    private volatile IntSupplier beyond = () -> 0;
    private volatile PortClock clock;
    private long accepted;
    private long handed;

    /** @param portName any name, for example {@code "/dev/SEAR_Robot_01"} or {@code "COM42"} */
    public VirtualSerialPort(String portName) {
        super(checked(portName));
    }

    private static String checked(String portName) {
        if (portName == null || portName.trim().isEmpty()) {
            throw new IllegalArgumentException(
                "a virtual serial port needs a name, for example \"/dev/SEAR_Robot_01\"");
        }
        return portName;
    }

    /** Joins two ports: bytes written to one are read from the other. Removes cables that either port has already. */
    public static void makeNullModem(VirtualSerialPort a, VirtualSerialPort b) {
        if (a == null || b == null || a == b) {
            throw new IllegalArgumentException("a null-modem cable has two ends: give it two different virtual ports");
        }
        a.unplug();
        b.unplug();
        a.peer = b;
        b.peer = a;
    }

    /** Removes the cable from both ends. */
    public void unplug() {
        VirtualSerialPort other = peer;
        peer = null;
        if (other != null && other.peer == this) {
            other.peer = null;
        }
    }

    /** Port at the other end of the cable; null without cable. */
    public VirtualSerialPort getPeer() {
        return peer;
    }

    /**
     * Sets whether bytes take the time of the baud rate here; default true. False if a simulated device keeps that
     * time.
     */
    public void setPaced(boolean on) {
        paced = on;
    }

    /**
     * Reserves the port's name.
     *
     * @param who owner as text, for example {@code "LIDAR myLidar of the running simulation"}; null for none
     */
    public void setOwner(String who) {
        owner = who;
    }

    /**
     * Sets the advice for a service that requests this port while another service has it; null for "disconnect() there
     * first".
     */
    public void setWayOut(String advice) {
        wayOut = advice == null ? WAY_OUT : advice;
    }

    /** See {@link #setOwner}. */
    public String getOwner() {
        return owner;
    }

    /** Sets the callback for each change of this port's baud rate; it gets 0 when the port closes. */
    public void setBaudListener(IntConsumer listener) {
        baudListener = listener;
    }

    /** Sets the callback for each opening of the port, like DTR on a real one. */
    public void setOpenListener(Runnable listener) {
        openListener = listener;
    }

    /**
     * Sets the callback of the reader thread after each piece, with the total number of bytes delivered. The next piece
     * waits for its return.
     */
    public void setHandedHook(LongConsumer hook) {
        handedHook = hook;
    }

    /** Sets the source of the number of bytes that wait behind the other end, on a simulated device's line. */
    public void setBeyond(IntSupplier waiting) {
        beyond = waiting;
    }

    /**
     * Waits until the other end accepts bytes, that is until fewer than {@link #BUFFER} wait there. Writing without
     * this call never blocks.
     *
     * @return number of bytes that it accepts now, above 0; 0 if this port was closed meanwhile
     */
    public int awaitRoom() throws InterruptedException {
        while (opened) {
            VirtualSerialPort other = peer;
            long room = other == null ? BUFFER : BUFFER - other.getPending() - beyond.getAsInt();
            if (room > 0) {
                return (int) room;
            }
            synchronized (lock) {
                if (opened) {
                    lock.wait(LOOK_FOR_ROOM);
                }
            }
        }
        return 0;
    }

    /** Clock for the time-outs of this port's user. */
    public PortClock getClock() {
        PortClock own = clock;
        return own == null ? PortClock.WALL : own;
    }

    /** Sets {@link #getClock}; null for the computer's clock. */
    public void setClock(PortClock newClock) {
        clock = newClock;
    }

    @Override
    public boolean isHardware() {
        return false;
    }

    @Override
    public List<String> getPortNames() {
        return new ArrayList<>();
    }

    @Override
    public boolean isOpen() {
        return opened;
    }

    @Override
    public void open() throws IOException {
        synchronized (lock) {
            if (!opened) {
                super.open();
                opened = true;
                openListener.run();
            }
        }
    }

    private void reopen() {
        try {
            open();
        } catch (IOException e) {
            throw new IllegalStateException("port " + portName + " can't be opened: " + e.getMessage(), e);
        }
    }

    /** Closes the port, ends its reader thread and removes its listeners; bytes on their way are lost. */
    @Override
    public void close() {
        synchronized (lock) {
            opened = false;
            incoming.clear();
            handed = accepted;
            rate = DEFAULT_BAUD;
            listeners.clear(); // under this lock, else the reader thread would see a partly cleared map
            lock.notifyAll();
        }
        super.close(); // waits for the reader thread, which needs the lock to end
        synchronized (lock) {
            if (!opened) {
                listeners.clear();
            }
        }
        baudListener.accept(0);
    }

    /** Whether the port has a listener that receives its bytes. */
    boolean isInUse() {
        synchronized (lock) {
            return readingThread != null && !listeners.isEmpty();
        }
    }

    private boolean isOthers(Map<String, SerialDataListener> added) {
        synchronized (lock) {
            return isInUse() && Collections.disjoint(listeners.keySet(), added.keySet());
        }
    }

    /** @throws IllegalStateException if another service has the port and was not merely reconnected to it */
    @Override
    public void listen(Map<String, SerialDataListener> added) {
        if (isOthers(added)) {
            PortArrivals.giveWay(portName);
            reopen();
        }
        synchronized (lock) {
            if (isOthers(added)) {
                throw new IllegalStateException("port " + portName + " is in use by " + listeners.keySet()
                    + ": " + wayOut);
            }
            listening = true;
            super.listen(added);
        }
    }

    /** Listeners that receive this port's bytes. */
    public List<SerialDataListener> getListeners() {
        synchronized (lock) {
            return new ArrayList<>(listeners.values());
        }
    }

    /**
     * Sets baud rate and format of this end.
     *
     * @param newRate bits per second, 50 to 4000000
     */
    @Override
    public boolean setParams(int newRate, int newDataBits, int newStopBits, int newParity) {
        if (newRate < LOWEST_BAUD || newRate > HIGHEST_BAUD) {
            throw new IllegalArgumentException("baud rate of port " + portName + " is " + newRate + ", legal: "
                + LOWEST_BAUD + " to " + HIGHEST_BAUD);
        }
        rate = newRate;
        dataBits = newDataBits;
        stopBits = newStopBits;
        parity = newParity;
        baudListener.accept(newRate);
        return true;
    }

    /** Restores the default baud rate, for a simulated device that works at any rate. */
    public void forgetBaud() {
        rate = DEFAULT_BAUD;
        baudListener.accept(0);
    }

    @Override
    public void write(int data) throws IOException {
        write(new byte[] {(byte) data});
    }

    @Override
    public void write(byte[] data) throws IOException {
        VirtualSerialPort other = peer;
        if (!opened) {
            throw new IOException("port " + portName + " is closed: connect to it before writing");
        }
        if (other == null) {
            throw new IOException("nothing is plugged into port " + portName
                + ": start the simulation that has it, or join it to another with VirtualSerialPort.makeNullModem");
        }
        other.arrive(data.clone(), paced && other.paced ? Uart.seconds(1, Math.min(rate, other.rate)) : 0);
    }

    private void arrive(byte[] data, double byteTime) {
        synchronized (lock) {
            if (!opened || data.length == 0) {
                return;
            }
            accepted += data.length;
            if (byteTime > 0) {
                incoming.add(data, PortClock.current(), byteTime);
            } else {
                incoming.add(data);
            }
            lock.notifyAll();
        }
    }

    /** Waits for bytes; returns null when the port is closed. */
    @Override
    public byte[] readBytes() throws InterruptedException {
        while (true) {
            ByteQueue.Burst head;
            synchronized (lock) {
                while (opened && incoming.isEmpty()) {
                    lock.wait();
                }
                if (!opened) {
                    return null;
                }
                byte[] bytes = incoming.take(Backlog.PIECE);
                if (bytes.length > 0) {
                    return bytes;
                }
                head = incoming.head();
            }
            head.await();
        }
    }

    /** Loop of the reader thread: delivers bytes to the listeners until the port is closed. */
    @Override
    public void run() {
        try {
            while (isReader()) {
                byte[] bytes = readBytes();
                if (bytes != null && isReader()) {
                    passOn(bytes);
                }
            }
        } catch (InterruptedException e) {
            log.debug("reader of port {} was interrupted", portName);
        }
    }

    private boolean isReader() {
        synchronized (lock) {
            return readingThread == Thread.currentThread();
        }
    }

    private void passOn(byte[] bytes) {
        for (SerialDataListener listener : getListeners()) {
            try {
                listener.onBytes(bytes);
            } catch (RuntimeException e) {
                log.error("{} failed on bytes from port {}", listener.getName(), portName, e);
            }
            Backlog.await(listener, TIMEOUT);
        }
        handedHook.accept(getHanded() + bytes.length);
        synchronized (lock) {
            if (readingThread == Thread.currentThread()) {
                handed += bytes.length;
            }
            lock.notifyAll();
        }
    }

    /** Total number of bytes that have arrived while the port was open. */
    public long getAccepted() {
        synchronized (lock) {
            return accepted;
        }
    }

    private long getHanded() {
        synchronized (lock) {
            return handed;
        }
    }

    /**
     * Number of received bytes that the listeners have not processed yet; 0 on the reader thread, which processes them.
     */
    public long getPending() {
        synchronized (lock) {
            return Thread.currentThread() == readingThread ? 0 : accepted - handed;
        }
    }

    /**
     * Waits until the listeners have processed all received bytes; returns immediately on the reader thread.
     *
     * @return whether they have
     */
    public boolean awaitHanded(long millis) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
        synchronized (lock) {
            while (accepted != handed && Thread.currentThread() != readingThread) {
                long left = end - System.nanoTime();
                if (left <= 0) {
                    return false;
                }
                TimeUnit.NANOSECONDS.timedWait(lock, Math.max(left, TimeUnit.MILLISECONDS.toNanos(1)));
            }
            return true;
        }
    }
}
