// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.io.IOException;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.SEAR.devices.RepeatedWarnings;
import org.SEAR.devices.SerialLine;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.serial.Backlog;
import org.myrobotlab.serial.PortArrivals;
import org.myrobotlab.serial.PortClock;
import org.myrobotlab.serial.PortUser;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.interfaces.SerialDataListener;
import org.myrobotlab.service.link.FindsBaudRate;
import org.myrobotlab.service.link.Reconnects;
import org.myrobotlab.service.sear.Host;

/**
 * Connects the user's port to a simulated device: two virtual ports with a null-modem cable, whose device end has one
 * of MyRobotLab's Serial services. The user's bytes reach SEAR as publishBytes messages of that service. The device's
 * bytes leave through the same service. The simulated line models the baud rate, so the ports don't. Any thread.
 */
final class UartLine implements ExternalLine {
    /** Milliseconds; shorter than lock-step waits for a port, longer than a busy machine delays a thread. */
    private static final long TIMEOUT = TimeUnit.SECONDS.toMillis(50);
    /** Longest wait of the simulation thread for MyRobotLab's outgoing messages, ns. */
    private static final long OUTBOX_TIMEOUT = TimeUnit.MILLISECONDS.toNanos(50);
    /**
     * Bytes that may wait for the reader of the user's port before a simulation "as fast as possible" waits; size of a
     * driver's buffer.
     */
    private static final int MAX_PENDING = 4096;
    private static final String DRIVE = "Dynamics";
    private static final String CALLBACK = "onUartBytes";
    private static final String PUBLISHER = "publishBytes";

    private final SerialLine line;
    private final String serviceName;
    private final Host host;
    private final VirtualSerialPort uart;
    private final VirtualSerialPort user;
    private final RepeatedWarnings repeats = new RepeatedWarnings();
    private final PendingBytes held = new PendingBytes();
    private Serial serial;
    private long given;
    private volatile SerialLine.Sink reader;
    private final Runnable driven;
    private boolean complained;

    /**
     * @param serviceName as in {@link #serviceNames}
     * @param driven called when an external program drives a robot
     */
    UartLine(SerialLine line, String serviceName, Host host, Runnable driven) {
        this.line = line;
        this.driven = driven;
        this.host = host;
        this.serviceName = serviceName;
        uart = new VirtualSerialPort(line.getUartPort());
        user = new VirtualSerialPort(line.getUserPort());
    }

    /**
     * Returns the service names. {@code myLidar_LIDARsimulator_Serial_Service} is the dissertation's name, by which
     * SEAR finds the sensor. If several robots have a part of that name,
     * {@code rover_myLidar_LIDARsimulator_Serial_Service}, because service names contain no slash. If a part is itself
     * named {@code rover_myLidar}, the other name gets a number: {@code rover_myLidar_2_LIDARsimulator_Serial_Service}.
     */
    static Map<SerialLine, String> serviceNames(Collection<SerialLine> lines) {
        Map<SerialLine, String> names = new IdentityHashMap<>();
        Set<String> taken = new HashSet<>();
        for (boolean shared : new boolean[] {false, true}) {
            for (SerialLine line : lines) {
                if (line.getObjectName().indexOf('/') >= 0 == shared) {
                    names.put(line, freeName(line, taken));
                }
            }
        }
        return names;
    }

    private static String freeName(SerialLine line, Set<String> taken) {
        String part = line.getObjectName().replace('/', '_');
        String rest = "_" + (DRIVE.equals(line.getObjectType()) ? "ROBOT" : line.getObjectType())
            + "simulator_Serial_Service";
        String name = part + rest;
        for (int number = 2; !taken.add(name); number++) {
            name = part + "_" + number + rest;
        }
        return name;
    }

    /**
     * Creates ports, cable and service.
     *
     * @throws IOException if a port or the service is not available
     */
    void open(PortClock clock) throws IOException {
        VirtualSerialPort.makeNullModem(uart, user);
        setClock(clock);
        String owner = line.getObjectType() + " " + line.getObjectName() + " of the running simulation";
        for (VirtualSerialPort port : new VirtualSerialPort[] {uart, user}) {
            port.setPaced(false);
            SerialDeviceFactory.add(port);
            port.setOwner(owner);
        }
        uart.setWayOut("it is the simulated device's own end, connect to " + user.getName());
        uart.setHandedHook(this::awaitDevice);
        user.setBaudListener(this::hostBaud);
        user.setBeyond(line::getWaiting);
        user.setOpenListener(line::open);
        ServiceInterface started = Runtime.start(serviceName, "Serial");
        if (!(started instanceof Serial)) {
            throw new IOException("a service named " + serviceName + " already exists and is not a Serial service: "
                + "release it first");
        }
        serial = (Serial) started;
        leaveOutOfSavedConfigurations();
        serial.connect(uart.getName());
        serial.addListener(PUBLISHER, host.getName(), CALLBACK);
        line.setSink(this::toUser);
    }

    /** Sets the clock of both ports. */
    void setClock(PortClock clock) {
        uart.setClock(clock);
        user.setClock(clock);
    }

    /**
     * Removes this service from the Runtime's configuration: the simulation starts it, so a saved configuration must
     * not.
     */
    private void leaveOutOfSavedConfigurations() {
        Runtime.getInstance().getConfig().remove(serviceName);
    }

    private void hostBaud(int baud) {
        line.setHostBaud(baud);
        if (line.hearsEveryBaud() || user.getListeners().stream().anyMatch(FindsBaudRate.class::isInstance)) {
            return;
        }
        if (baud != 0 && baud != line.getDeviceBaud()) {
            String text;
            synchronized (repeats) {
                text = repeats.count("baud", line.getObjectType() + " " + line.getObjectName() + " talks at "
                    + line.getDeviceBaud()
                    + " baud, but port " + user.getName() + " was set to " + baud + ": open the port at "
                    + line.getDeviceBaud() + " baud" + remedy(baud));
            }
            if (text != null) {
                host.warn(text);
            }
        }
    }

    /** Returns the call that sets the baud rate of a robot's drive. */
    private String remedy(int baud) {
        return isDrive() ? ", as Runtime.getService(\"serial\").connect(\"" + user.getName() + "\", "
            + line.getDeviceBaud() + ", 8, 1, 0), or robot.getPart(\"" + line.getObjectName() + "\").setBaud(" + baud
            + ") before the start" : "";
    }

    /** Takes bytes from the device on the simulation thread. Bytes of a lock-step step wait for the port's turn. */
    private void toUser(byte[] bytes, int[] starts) {
        SerialLine.Sink outside = reader;
        if (outside != null) {
            guarded(() -> outside.receive(bytes, starts));
        } else if (!held.keep(bytes)) {
            synchronized (held) {
                handOver();
                send(bytes);
            }
        }
    }

    /** @param on whether a step of lock-step is in progress; the device's bytes then wait for {@link #handOver} */
    void setStepping(boolean on) {
        held.setStepping(on);
    }

    /**
     * Sends the bytes that the device sent in a step of lock-step. Thread that advances time.
     *
     * @return whether there were any
     */
    boolean handOver() {
        synchronized (held) { // no other bytes may overtake these
            byte[] bytes = held.take();
            send(bytes);
            return bytes.length > 0;
        }
    }

    private void send(byte[] bytes) {
        guarded(() -> {
            for (int at = 0; at < bytes.length && uart.isOpen(); at += Backlog.PIECE) {
                Backlog.await(serial, OUTBOX_TIMEOUT);
                serial.write(Arrays.copyOfRange(bytes, at, Math.min(bytes.length, at + Backlog.PIECE)));
            }
        });
    }

    /** An action that may throw at MyRobotLab's ports. */
    private interface Sending {
        void run() throws Exception;
    }

    /** Ignores errors after the UART was closed, as when MyRobotLab ends. */
    private void guarded(Sending sending) {
        try {
            sending.run();
        } catch (Exception e) {
            if (uart.isOpen()) {
                complain("bytes from " + line.getObjectName() + " did not reach port " + user.getName() + ": " + e);
            }
        }
    }

    @Override
    public void write(byte[] bytes) {
        if (isDrive()) {
            driven.run();
        }
        line.write(bytes);
    }

    @Override
    public void setReader(SerialLine.Sink newReader) {
        reader = newReader;
    }

    @Override
    public void pickUp() {
        line.open();
    }

    @Override
    public void hangUp() {
        line.hangUp();
    }

    @Override
    public int getDeviceBaud() {
        return line.getDeviceBaud();
    }

    /** Takes bytes of the user from MyRobotLab's message. */
    void toDevice(byte[] bytes) {
        line.write(bytes);
        synchronized (this) {
            given += bytes.length;
            notifyAll();
        }
    }

    /** Waits on the UART's reader thread after each piece until it has passed MyRobotLab's message queues. */
    private synchronized void awaitDevice(long handed) {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(TIMEOUT);
        try {
            while (given < handed && System.nanoTime() < end) {
                wait(TIMEOUT);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (given < handed && uart.isOpen()) {
            complain((handed - given) + " bytes written to port " + user.getName()
                + " did not come through MyRobotLab's messages");
            given = handed;
        }
    }

    private void complain(String message) {
        if (!complained) {
            complained = true;
            host.warn(message);
        }
    }

    /** Returns whether bytes arrive faster than MyRobotLab and the program at the user's port take them. */
    boolean isBehind() {
        return Backlog.isLong(serial) || user.getPending() > MAX_PENDING;
    }

    /** Returns whether the device is a robot's drive. */
    boolean isDrive() {
        return DRIVE.equals(line.getObjectType());
    }

    /** Returns the name of the Serial service at the device's end. */
    String getServiceName() {
        return serviceName;
    }

    VirtualSerialPort getUserPort() {
        return user;
    }

    /**
     * Reconnects listeners when the port returns: a real device that is switched off and on stays reachable through its
     * open port. Drivers that reconnect do it themselves.
     */
    private void reconnectWhenBack(Serial service, List<SerialDataListener> listeners) {
        String port = user.getName();
        boolean driven = false;
        for (SerialDataListener listener : listeners) {
            if (listener instanceof Reconnects) {
                driven = true;
                ((Reconnects) listener).reconnectWhenBack(port, true);
            }
        }
        if (!driven) {
            PortArrivals.await(new PortUser(service.getName(), port, true, () -> reconnect(service, port, host), () -> {
                if (port.equals(service.getPortName())) {
                    service.disconnect();
                }
            }));
        }
    }

    private static void reconnect(Serial service, String port, Host host) {
        if (Runtime.getService(service.getName()) == service && !service.isConnected()) {
            try {
                service.connect(port);
            } catch (IOException | RuntimeException e) {
                host.warn(service.getName() + " is not connected to port " + port + " again: " + e.getMessage());
            }
        }
    }

    /** Removes service and ports. Disconnects listeners of the user's port until a simulation has it again. */
    void close() {
        List<SerialDataListener> listeners = user.getListeners();
        for (SerialDataListener listener : listeners) {
            if (listener instanceof Serial && user.getName().equals(((Serial) listener).getPortName())) {
                ((Serial) listener).disconnect();
                reconnectWhenBack((Serial) listener, listeners);
            }
        }
        if (serial != null) {
            serial.removeListener(PUBLISHER, host.getName(), CALLBACK);
            serial.disconnect();
            Runtime.releaseService(serviceName);
        }
        for (VirtualSerialPort port : new VirtualSerialPort[] {uart, user}) {
            if (port.getOwner() != null) {
                port.setOwner(null);
                SerialDeviceFactory.remove(port);
            }
        }
    }
}
