package org.myrobotlab.service.sear.export;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import org.SEAR.devices.SerialLine;
import org.myrobotlab.serial.Port;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.run.SimulationControl;
import org.myrobotlab.service.sear.run.SimulationSession;

/** The virtual ports that programs outside MyRobotLab can open. Any thread. */
public final class Exports {
    private final Host host;
    private final SimulationControl control;
    private final Map<String, PortBridge> bridges = new LinkedHashMap<>();

    public Exports(Host host, SimulationControl control) {
        this.host = host;
        this.control = control;
    }

    /**
     * Makes a pseudo-terminal for a port.
     *
     * @param link path of a symbolic link to make to it, or null
     * @return path to open: the link's, or the terminal's own, for example {@code /dev/pts/3}
     * @throws IOException if there is no such port, or it is in use, or this system has no pseudo-terminals
     */
    public synchronized String terminal(String port, String link) throws IOException {
        PortBridge bridge = bridge(port);
        PseudoTerminal terminal = PseudoTerminal.open(port, link, baudOf(port));
        bridge.add(terminal);
        return terminal.getPath();
    }

    /**
     * Makes a TCP server on the loopback address for a port: raw bytes.
     *
     * @param number of the TCP port, 0 for any free one
     * @return the number
     */
    public synchronized int tcp(String port, int number) throws IOException {
        PortBridge bridge = bridge(port);
        TcpEndpoint server = TcpEndpoint.open(port, number);
        bridge.add(server);
        return server.getNumber();
    }

    private PortBridge bridge(String name) throws IOException {
        PortBridge present = bridges.get(name);
        if (present != null && present.isOpen()) {
            return present;
        }
        Port port = SerialDeviceFactory.get(name);
        if (!(port instanceof VirtualSerialPort)) {
            throw new IOException("there is no virtual port \"" + name + "\"; there are " + names());
        }
        PortBridge bridge = new PortBridge((VirtualSerialPort) port, host);
        bridges.put(name, bridge);
        return bridge;
    }

    private static StringBuilder names() {
        StringBuilder names = new StringBuilder();
        SerialDeviceFactory.getVirtualPorts().forEach(port -> names.append(names.length() == 0 ? "" : ", ").append(port.getName()));
        return names;
    }

    private int baudOf(String port) {
        SimulationSession session = control.sessionOrNull();
        if (session != null) {
            for (SerialLine line : session.getSimulation().getLines()) {
                if (line.getUserPort().equals(port)) {
                    return line.getDeviceBaud();
                }
            }
        }
        return 0;
    }

    /** Takes all of them away. */
    public synchronized void close() {
        bridges.values().forEach(PortBridge::close);
        bridges.clear();
    }
}
