package org.myrobotlab.service.sear;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.myrobotlab.framework.QueueStats;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.interfaces.SerialDataListener;

/** Passes bytes between a virtual port and programs outside. Any thread. */
final class PortBridge implements SerialDataListener {
    private static final int DATA_BITS = 8;
    private static final int STOP_BITS = 1;
    private static final int NO_PARITY = 0;

    private final VirtualSerialPort port;
    private final Host host;
    private final List<OuterEnd> ends = new CopyOnWriteArrayList<>();

    /** @throws IOException if another has the port */
    PortBridge(VirtualSerialPort port, Host host) throws IOException {
        this.port = port;
        this.host = host;
        if (port.isOpen()) {
            throw new IOException("port " + port.getName() + " is in use within MyRobotLab: disconnect() there before exporting it");
        }
        port.open();
        port.listen(this);
    }

    void add(OuterEnd end) {
        ends.add(end);
        end.start(this::fromOutside, this::setBaud);
    }

    private void fromOutside(byte[] bytes) {
        try {
            port.write(bytes);
        } catch (IOException e) {
            host.warn("bytes for exported port " + port.getName() + " were lost: " + e.getMessage());
        }
    }

    private void setBaud(int baud) {
        try {
            port.setParams(baud, DATA_BITS, STOP_BITS, NO_PARITY);
        } catch (IllegalArgumentException e) {
            host.warn(e.getMessage());
        }
    }

    boolean isOpen() {
        return port.isOpen();
    }

    void close() {
        ends.forEach(OuterEnd::close);
        ends.clear();
        port.close();
    }

    @Override
    public void onBytes(byte[] bytes) {
        ends.forEach(end -> end.write(bytes));
    }

    @Override
    public String getName() {
        return "export of " + port.getName();
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
        // Nobody looks at them.
    }
}
