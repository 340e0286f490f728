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
 * A driver's connection through one of MyRobotLab's Serial services, to a real or a virtual port; with a clock for time-outs, which stands still
 * when the simulation behind the port does. Any thread.
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
     * @param serial the service to connect with
     * @param driver gets the bytes, on the port's reader thread
     * @param tick called again and again while connected, in lock-step after each step, for time-outs
     * @param lost called within a second, again and again, while {@link #isLost}: whoever it is calls {@link #close}
     */
    public SerialLink(Serial serial, SerialDataListener driver, Runnable tick, Runnable lost) {
        this.serial = serial;
        this.driver = driver;
        this.tick = tick;
        this.lost = lost;
    }

    /**
     * Opens a port; a connection to another is closed first.
     *
     * @throws IOException that says what is wrong and which ports there are
     */
    public synchronized void connect(String port, int newBaud) throws IOException {
        if (port == null || port.trim().isEmpty()) {
            throw new IOException("no port given; there are " + known());
        }
        disconnect();
        serial.addByteListener(driver);
        try {
            serial.connect(port, newBaud, DATA_BITS, STOP_BITS, NO_PARITY);
        } catch (IllegalStateException | IllegalArgumentException e) {
            throw new IOException(driver.getName() + " can't connect: " + e.getMessage(), e);
        } catch (IOException e) {
            throw new IOException(driver.getName() + " can't connect to port \"" + port + "\": " + e.getMessage() + "; there are " + known(), e);
        }
        if (!port.equals(serial.getPortName())) {
            throw new IOException(driver.getName() + " can't connect to port \"" + port + "\": there is no such port, or it is in use; there are "
                + known());
        }
        opened = serial.getPort();
        baud = newBaud;
        portName = port;
        timeOuts.restart();
        clock().addTicker(tick);
        timer = Executors.newSingleThreadScheduledExecutor(SerialLink::daemon);
        timer.scheduleWithFixedDelay(this::tickByWall, TICK_MILLIS, TICK_MILLIS, TimeUnit.MILLISECONDS);
    }

    /** The clock of the port that is or was open; a simulation that is reset has another one afterwards. */
    private PortClock clock() {
        Port port = opened;
        return port instanceof VirtualSerialPort ? ((VirtualSerialPort) port).getClock() : PortClock.WALL;
    }

    /** Whether one end of the cable has bytes that nobody has got yet. */
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
        return "the ports " + getPortNames() + notStarted();
    }

    /** Where the script has a simulation and has not started it, its ports are not there yet. */
    private static String notStarted() {
        return SerialDeviceFactory.getVirtualPorts().isEmpty() ? Runtime.getServices().stream().filter(one -> one.getClass().getSimpleName()
            .equals("SEAR")).map(one -> "; no port is simulated now: " + one.getName() + ".startSimulation() makes those of the project")
            .findFirst().orElse("") : "";
    }

    /** Names of the ports that there are, in order. */
    public List<String> getPortNames() {
        TreeSet<String> names = new TreeSet<>(serial.getPortNames());
        names.removeIf(SerialDeviceFactory::isGone);
        return new ArrayList<>(names);
    }

    /** Closes the port, if one is open. */
    public synchronized void disconnect() {
        close();
        if (serial.isConnected()) {
            serial.disconnect();
        }
    }

    /**
     * Closes a port that somebody else has closed already, in one step: of several threads that notice it one is told, and none ends what another has
     * connected meanwhile.
     *
     * @param forget is done in this step, by the one who is told
     * @return the port's name; null if it is open, or none is
     */
    public synchronized String closeIfLost(Runnable forget) {
        String port = isLost() ? portName : null;
        if (port != null) {
            close();
            forget.run();
        }
        return port;
    }

    /** Stops the time-outs; the thread of theirs that calls it goes on to its end. */
    private void close() {
        portName = null;
        clock().removeTicker(tick);
        if (timer != null) {
            timer.shutdown();
            timer = null;
        }
    }

    /** Whether the port was closed by somebody else, at the Serial service or, if it is a virtual one, by itself. */
    public boolean isLost() {
        return portName != null && (!serial.isConnected() || opened instanceof VirtualSerialPort && !opened.isOpen());
    }

    /** Name of the port that is open; null if none is. */
    public String getPortName() {
        return portName;
    }

    /** The present speed of the port, bits a second. */
    public int getBaud() {
        return baud;
    }

    /** Changes the speed of the open port. */
    public void setBaud(int newBaud) {
        try {
            serial.setParams(newBaud, DATA_BITS, STOP_BITS, NO_PARITY);
            baud = newBaud;
        } catch (IOException e) {
            throw new IllegalStateException("port " + portName + " can't be set to " + newBaud + " baud: " + e.getMessage(), e);
        }
    }

    /** Sets the line DTR of the open port, if it has one. */
    public void setDtr(boolean on) {
        serial.setDTR(on);
    }

    /** Seconds, by the clock of the simulation behind the port or by the computer's. */
    public double now() {
        return clock().now();
    }

    /** Seconds for time-outs, see {@link TimeOutClock}. */
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
