// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import org.SEAR.devices.RepeatedWarnings;
import org.myrobotlab.framework.QueueStats;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.interfaces.SerialDataListener;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.run.ExternalLine;

/**
 * Transfers bytes between external programs and the virtual port of one name while it exists; drops bytes otherwise.
 * Any thread.
 */
final class PortBridge implements SerialDataListener {
    private static final int DATA_BITS = 8;
    private static final int STOP_BITS = 1;
    private static final int NO_PARITY = 0;
    private static final int[] ONE_MESSAGE = {0};

    private final String name;
    private final Host host;
    private final RepeatedWarnings repeats = new RepeatedWarnings();
    private final List<LineEnd> ends = new CopyOnWriteArrayList<>();
    /** Ends with a program; the rate of the last one is in force. Guarded by this. */
    private final List<LineEnd> inUse = new ArrayList<>();
    private volatile VirtualSerialPort port;
    /** Direct path to a simulated device; null for a port without one. */
    private volatile ExternalLine line;
    /** Rate last set at the port, 0 for the device's own. Guarded by this. */
    private int applied;

    PortBridge(String name, Host host) {
        this.name = name;
        this.host = host;
    }

    /**
     * Connects to the port of this name.
     *
     * @param direct direct path to its simulated device; null if there is none
     * @throws IOException if the port is in use
     */
    void attach(VirtualSerialPort present, ExternalLine direct) throws IOException {
        if (present == port && present.isOpen()) {
            return;
        }
        if (present.isOpen()) {
            throw new IOException("port " + name + " is in use within MyRobotLab: disconnect() there before "
                + "exporting it");
        }
        present.open();
        present.listen(this);
        present.setWayOut("endExport(\"" + name + "\") of the SEAR service first");
        line = direct;
        ends.forEach(end -> end.getEndpoint().deviceAt(getDeviceBaud()));
        if (direct != null) {
            direct.setReader(this::write);
        }
        synchronized (this) {
            port = present;
            applied = 0;
            apply();
        }
    }

    /** Disconnects from the port. */
    void detach() {
        VirtualSerialPort present;
        ExternalLine direct;
        synchronized (this) {
            present = port;
            port = null;
            direct = line;
            line = null;
        }
        if (direct != null) {
            direct.setReader(null);
        }
        if (present != null) {
            present.close();
            present.setWayOut(null);
        }
    }

    boolean isAttached() {
        VirtualSerialPort present = port;
        return present != null && present.isOpen();
    }

    int getDeviceBaud() {
        ExternalLine direct = line;
        return direct == null ? 0 : direct.getDeviceBaud();
    }

    void add(ExternalEndpoint endpoint) {
        LineEnd end = new LineEnd(this, endpoint);
        ends.add(end);
        endpoint.deviceAt(getDeviceBaud());
        endpoint.start(end);
    }

    /** Ends one endpoint. */
    void remove(ExternalEndpoint endpoint) {
        for (LineEnd end : ends) {
            if (end.getEndpoint() == endpoint) {
                endpoint.close();
                leave(end);
                ends.remove(end);
            }
        }
    }

    boolean isEmpty() {
        return ends.isEmpty();
    }

    /** Returns a description of each endpoint. */
    List<String> describe() {
        return ends.stream().map(end -> end.getEndpoint().describe()).collect(Collectors.toList());
    }

    /** Puts the rate of this end in force. */
    synchronized void use(LineEnd end) {
        ExternalLine direct = line;
        if (inUse.isEmpty() && direct != null) {
            direct.pickUp();
        }
        if (inUse.isEmpty() || inUse.get(inUse.size() - 1) != end) {
            inUse.remove(end);
            inUse.add(end);
            apply();
        }
    }

    /** Puts the changed rate of an end in force. */
    synchronized void changed(LineEnd end) {
        inUse.remove(end);
        inUse.add(end);
        apply();
    }

    /** Removes an end without programs; puts the previous end's rate in force. */
    synchronized void leave(LineEnd end) {
        if (!inUse.remove(end)) {
            return;
        }
        ExternalLine direct = line;
        if (!inUse.isEmpty()) {
            apply();
        } else if (direct != null) {
            direct.hangUp();
        }
    }

    private void apply() {
        VirtualSerialPort present = port;
        int baud = inUse.isEmpty() ? 0 : inUse.get(inUse.size() - 1).getBaud();
        if (present == null || baud == applied) {
            return;
        }
        applied = baud;
        try {
            if (baud == 0) {
                present.forgetBaud();
            } else {
                present.setParams(baud, DATA_BITS, STOP_BITS, NO_PARITY);
            }
        } catch (IllegalArgumentException e) {
            warn("baud", e.getMessage());
        }
    }

    /** Sends bytes; blocks the program while the line is full, as a real port does. */
    void send(byte[] bytes) {
        VirtualSerialPort present = port;
        ExternalLine direct = line;
        if (present == null) {
            return;
        }
        try {
            for (int done = 0; done < bytes.length;) {
                int room = present.awaitRoom();
                if (room == 0) {
                    return;
                }
                int end = Math.min(bytes.length, done + room);
                byte[] piece = Arrays.copyOfRange(bytes, done, end);
                if (direct != null) {
                    direct.write(piece);
                } else {
                    present.write(piece);
                }
                done = end;
            }
        } catch (IOException e) {
            if (present == port && present.isOpen()) {
                warn("loss", "bytes for exported port " + name + " were lost: " + e.getMessage());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    void warn(String cause, String message) {
        String text;
        synchronized (repeats) {
            text = repeats.count(cause, message);
        }
        if (text != null) {
            host.warn(text);
        }
    }

    void close() {
        detach();
        ends.forEach(end -> end.getEndpoint().close());
        ends.clear();
    }

    private void write(byte[] bytes, int[] starts) {
        ends.forEach(end -> end.getEndpoint().write(bytes, starts));
    }

    /** Takes bytes of a port without a simulated device; each piece counts as a message. */
    @Override
    public void onBytes(byte[] bytes) {
        write(bytes, ONE_MESSAGE);
    }

    @Override
    public String getName() {
        return "export of " + name;
    }

    @Override
    public void onConnect(String portName) {
        // The bridge itself has opened the port.
    }

    @Override
    public void onDisconnect(String portName) {
        // The bridge itself closes the port.
    }

    @Override
    public QueueStats publishStats(QueueStats stats) {
        return stats;
    }

    @Override
    public void updateStats(QueueStats stats) {
        // No statistics needed.
    }
}
