package org.myrobotlab.service.sear.export;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.SEAR.devices.RepeatedWarnings;
import org.myrobotlab.framework.QueueStats;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.interfaces.SerialDataListener;
import org.myrobotlab.service.sear.Host;

/** Passes bytes between a virtual port and programs outside. Any thread. */
final class PortBridge implements SerialDataListener {
    private static final int DATA_BITS = 8;
    private static final int STOP_BITS = 1;
    private static final int NO_PARITY = 0;

    private final VirtualSerialPort port;
    private final Host host;
    private final RepeatedWarnings repeats = new RepeatedWarnings();
    private final List<ExternalEndpoint> ends = new CopyOnWriteArrayList<>();

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

    void add(ExternalEndpoint end) {
        ends.add(end);
        end.start(this::fromOutside, this::setBaud);
    }

    /** Holds the program up while the line is full, as a real port does. */
    private void fromOutside(byte[] bytes) {
        try {
            for (int done = 0; done < bytes.length;) {
                int room = port.awaitRoom();
                if (room == 0) {
                    return;
                }
                int end = Math.min(bytes.length, done + room);
                port.write(Arrays.copyOfRange(bytes, done, end));
                done = end;
            }
        } catch (IOException e) {
            warn("loss", "bytes for exported port " + port.getName() + " were lost: " + e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void warn(String cause, String message) {
        String text;
        synchronized (repeats) {
            text = repeats.count(cause, message);
        }
        if (text != null) {
            host.warn(text);
        }
    }

    private void setBaud(int baud) {
        try {
            port.setParams(baud, DATA_BITS, STOP_BITS, NO_PARITY);
        } catch (IllegalArgumentException e) {
            warn("baud", e.getMessage());
        }
    }

    boolean isOpen() {
        return port.isOpen();
    }

    void close() {
        port.close();
        ends.forEach(ExternalEndpoint::close);
        ends.clear();
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
