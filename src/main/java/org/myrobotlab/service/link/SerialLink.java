// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.link;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.myrobotlab.serial.Port;
import org.myrobotlab.serial.PortClock;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.interfaces.SerialDataListener;

/**
 * A driver's connection to a real or virtual port through one of MyRobotLab's Serial services. Has a clock for
 * time-outs that stands still while the simulation behind the port does. Any thread.
 */
public final class SerialLink {
    private static final int DATA_BITS = 8;
    private static final int STOP_BITS = 1;
    private static final int NO_PARITY = 0;
    private static final long TICK_MILLIS = 20;

    private final Serial serial;
    private final SerialDataListener driver;
    private final Runnable tick;
    private final Runnable lost;
    private ScheduledExecutorService timer;
    private final TimeOutClock timeOuts = new TimeOutClock(this::clock, System::nanoTime, this::isUnderWay);
    private volatile Port opened;
    private volatile int baud;
    private volatile String portName;

    /**
     * @param serial the service that opens the port
     * @param driver gets the bytes, on the port's reader thread
     * @param tick called repeatedly while connected, in lock-step after each step, to check time-outs
     * @param lost called repeatedly while {@link #isLost}; must lead to {@link #closeIfLost}
     */
    public SerialLink(Serial serial, SerialDataListener driver, Runnable tick, Runnable lost) {
        this.serial = serial;
        this.driver = driver;
        this.tick = tick;
        this.lost = lost;
    }

    /**
     * Opens a port; closes the previous connection first.
     *
     * @throws IOException with the reason and the available ports
     */
    public synchronized void connect(String port, int newBaud) throws IOException {
        if (port == null || port.trim().isEmpty()) {
            throw new IOException("no port given; " + known());
        }
        disconnect();
        serial.addByteListener(driver);
        try {
            serial.connect(port, newBaud, DATA_BITS, STOP_BITS, NO_PARITY);
        } catch (IllegalStateException | IllegalArgumentException e) {
            throw new IOException(driver.getName() + " can't connect: " + e.getMessage(), e);
        } catch (IOException e) {
            throw new IOException(driver.getName() + " can't connect to port \"" + port + "\": " + e.getMessage() + "; "
                + known(), e);
        }
        if (!port.equals(serial.getPortName())) {
            throw new IOException(driver.getName() + " can't connect to port \"" + port + "\": there is no such port, "
                + "or it is in use; " + known());
        }
        opened = serial.getPort();
        baud = newBaud;
        portName = port;
        timeOuts.restart();
        clock().addTicker(tick);
        timer = Executors.newSingleThreadScheduledExecutor(SerialLink::daemon);
        timer.scheduleWithFixedDelay(this::tickByWall, TICK_MILLIS, TICK_MILLIS, TimeUnit.MILLISECONDS);
    }

    /** Returns the clock of the present or last port. A reset of the simulation replaces it. */
    private PortClock clock() {
        Port port = opened;
        return port instanceof VirtualSerialPort ? ((VirtualSerialPort) port).getClock() : PortClock.WALL;
    }

    /** Returns whether bytes wait at either end of the cable. */
    private boolean isUnderWay() {
        Port port = opened;
        if (!(port instanceof VirtualSerialPort)) {
            return false;
        }
        VirtualSerialPort own = (VirtualSerialPort) port;
        VirtualSerialPort peer = own.getPeer();
        return own.getPending() > 0 || peer != null && peer.getPending() > 0;
    }

    private static Thread daemon(Runnable work) {
        Thread thread = new Thread(work, "serial time-outs");
        thread.setDaemon(true);
        return thread;
    }

    private void tickByWall() {
        if (isLost()) {
            lost.run();
        } else if (!clock().isLockStep()) {
            tick.run();
        }
    }

    private String known() {
        return "available ports: " + getPortNames() + notStarted();
    }

    /** Returns a hint to start the simulation if a SEAR service exists and no port is simulated; else an empty text. */
    private static String notStarted() {
        return SerialDeviceFactory.getVirtualPorts().isEmpty() ? Runtime.getServices().stream()
            .filter(one -> one.getClass().getSimpleName()
            .equals("SEAR")).map(one -> "; no port is simulated now: " + one.getName() + ".startSimulation() creates "
                + "the project's ports")
            .findFirst().orElse("") : "";
    }

    /** Returns the names of the available ports, sorted. */
    public List<String> getPortNames() {
        TreeSet<String> names = new TreeSet<>(serial.getPortNames());
        names.removeIf(SerialDeviceFactory::isGone);
        return new ArrayList<>(names);
    }

    /** Closes the port if one is open. */
    public synchronized void disconnect() {
        close();
        if (serial.isConnected()) {
            serial.disconnect();
        }
    }

    /**
     * Closes a lost port and forgets it in one step. Of several threads that notice the loss only one gets the name,
     * and none closes a new connection.
     *
     * @param forget runs in this step if the port was lost
     * @return the port's name; null if no port was lost
     */
    public synchronized String closeIfLost(Runnable forget) {
        String port = isLost() ? portName : null;
        if (port != null) {
            close();
            forget.run();
        }
        return port;
    }

    /** Stops the time-outs. Safe on the timer's own thread: a running call completes. */
    private void close() {
        portName = null;
        clock().removeTicker(tick);
        if (timer != null) {
            timer.shutdown();
            timer = null;
        }
    }

    /** Returns whether the port was closed at the Serial service or, for a virtual port, at the port itself. */
    public boolean isLost() {
        return portName != null && (!serial.isConnected() || opened instanceof VirtualSerialPort && !opened.isOpen());
    }

    /** Returns the name of the open port; null if none is open. */
    public String getPortName() {
        return portName;
    }

    public int getBaud() {
        return baud;
    }

    public void setBaud(int newBaud) {
        try {
            serial.setParams(newBaud, DATA_BITS, STOP_BITS, NO_PARITY);
            baud = newBaud;
        } catch (IOException e) {
            throw new IllegalStateException("port " + portName + " can't be set to " + newBaud + " baud: "
                + e.getMessage(), e);
        }
    }

    /** Sets the DTR line of the open port, if it has one. */
    public void setDtr(boolean on) {
        serial.setDTR(on);
    }

    /** Returns seconds of the simulation behind the port, or of the computer's clock for a real port. */
    public double now() {
        return clock().now();
    }

    /** Returns seconds for time-outs, see {@link TimeOutClock}. */
    public double timeOutNow() {
        return timeOuts.now();
    }

    /**
     * Sends bytes.
     *
     * @throws IllegalStateException if the port is closed or broken
     */
    public void write(byte[] bytes) {
        if (portName == null) {
            throw new IllegalStateException(driver.getName() + " is not connected: call connect(port) first");
        }
        try {
            serial.write(bytes);
        } catch (Exception e) {
            throw new IllegalStateException("writing to port " + portName + " failed: " + e.getMessage(), e);
        }
    }
}
