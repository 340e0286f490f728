// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SerialObject;
import org.SEAR.grammar.ExportTarget;
import org.SEAR.grammar.ScriptText;
import org.myrobotlab.serial.Port;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.run.SimulationControl;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * The virtual ports that programs outside MyRobotLab can open. An export belongs to a port's name, not to a simulation.
 * It may be created before a simulation, and stays open but idle until a port of that name exists again. The start of a
 * simulation creates the exports of its project. Any thread.
 */
public final class Exports {
    /** Folder beside the project's folder for links of projects; projects create links only there. */
    public static final String FOLDER = "SEARports";

    private final Host host;
    private final SimulationControl control;
    private final Map<String, PortBridge> bridges = new LinkedHashMap<>();
    private final Map<String, Export> made = new LinkedHashMap<>();

    private static final class Export {
        private final PortBridge bridge;
        private final ExternalEndpoint endpoint;
        private final boolean ofProject;

        Export(PortBridge bridge, ExternalEndpoint endpoint, boolean ofProject) {
            this.bridge = bridge;
            this.endpoint = endpoint;
            this.ofProject = ofProject;
        }
    }

    /** Creates an endpoint. */
    private interface Opener {
        ExternalEndpoint open() throws IOException;
    }

    public Exports(Host host, SimulationControl control) {
        this.host = host;
        this.control = control;
    }

    /**
     * Creates a pseudo-terminal for a port; a repeated call returns the same one.
     *
     * @param link path of a symbolic link to create, or null
     * @return path to open: the link's, or the terminal's own, for example {@code /dev/pts/3}
     * @throws IOException if the running simulation has no such port, the port is in use, or the system lacks
     *     pseudo-terminals
     */
    public synchronized String terminal(String port, String link) throws IOException {
        return terminal(port, link == null ? null : ScriptText.path(link), false);
    }

    private String terminal(String port, Path link, boolean ofProject) throws IOException {
        String key = port + " terminal " + (link == null ? "" : link.toAbsolutePath().normalize());
        return ((PseudoTerminal) export(port, key, ofProject, () -> PseudoTerminal.open(port, link))).getPath();
    }

    /**
     * Creates a TCP server for a port on the loopback address, for raw bytes; a repeated call returns the same one.
     *
     * @param number TCP port, 0 for any free one
     * @return the number
     */
    public synchronized int tcp(String port, int number) throws IOException {
        return tcp(port, TcpSession.RAW, number, false);
    }

    /** Creates a TCP server by RFC 2217, through which the program sets the line's baud rate. */
    public synchronized int rfc2217(String port, int number) throws IOException {
        return tcp(port, Rfc2217.KIND, number, false);
    }

    private int tcp(String port, TcpSession.Kind kind, int number, boolean ofProject) throws IOException {
        String key = port + ' ' + kind.getName() + ' ' + number;
        return ((TcpEndpoint) export(port, key, ofProject, () -> TcpEndpoint.open(port, kind, number))).getNumber();
    }

    private ExternalEndpoint export(String port, String key, boolean ofProject, Opener opener) throws IOException {
        Export present = made.get(key);
        if (present != null) {
            if (!present.bridge.isAttached()) {
                attach(port, present.bridge);
            }
            return present.endpoint;
        }
        PortBridge bridge = bridges.get(port);
        boolean fresh = bridge == null;
        if (fresh) {
            bridge = new PortBridge(port, host);
        }
        if (!bridge.isAttached()) {
            attach(port, bridge);
        }
        try {
            ExternalEndpoint endpoint = opener.open();
            bridges.put(port, bridge);
            made.put(key, new Export(bridge, endpoint, ofProject));
            bridge.add(endpoint);
            return endpoint;
        } catch (IOException | RuntimeException e) {
            if (fresh) {
                bridge.close();
            }
            throw e;
        }
    }

    /** Connects a bridge to the port of its name, if it exists. */
    private void attach(String name, PortBridge bridge) throws IOException {
        Port port = SerialDeviceFactory.get(name);
        SimulationSession session = control.sessionOrNull();
        if (port instanceof VirtualSerialPort) {
            bridge.attach((VirtualSerialPort) port, session == null ? null : session.outsideLine(name));
        } else if (session != null) {
            throw new IOException("there is no virtual port \"" + name + "\"; virtual ports: " + names());
        }
    }

    private static String names() {
        StringBuilder names = new StringBuilder();
        SerialDeviceFactory.getVirtualPorts().forEach(port -> names.append(names.length() == 0 ? "" : ", ")
            .append(port.getName()));
        return names.length() == 0 ? "none" : names.toString();
    }

    /**
     * Connects the present exports to the ports of a new simulation and creates those of its project. Warns of
     * failures.
     */
    public synchronized void begin() {
        SimulationSession session = control.sessionOrNull();
        if (session == null) {
            return;
        }
        Map<String, ExportTarget> wanted = wanted(session);
        endThoseOfOtherProjects(wanted);
        bridges.forEach((name, bridge) -> orSay(name, () -> attach(name, bridge)));
        wanted.forEach((port, target) ->
            orSay(port, () -> host.progress("port " + port + " is exported as " + make(port, target))));
    }

    private static Map<String, ExportTarget> wanted(SimulationSession session) {
        Map<String, ExportTarget> wanted = new LinkedHashMap<>();
        for (SEARrobot robot : session.getSimulation().getProject().getRobots()) {
            for (SearObject part : robot.getComponents()) {
                String export = part instanceof SerialObject ? ((SerialObject) part).getExport() : null;
                if (export != null && ((SerialObject) part).getUserPort() != null) {
                    wanted.put(((SerialObject) part).getUserPort(), ExportTarget.of(export));
                }
            }
        }
        return wanted;
    }

    private void endThoseOfOtherProjects(Map<String, ExportTarget> wanted) {
        List<String> gone = new ArrayList<>();
        made.forEach((key, export) -> {
            if (export.ofProject && wanted.entrySet().stream()
                .noneMatch(one -> key.equals(keyOf(one.getKey(), one.getValue())))) {
                gone.add(key);
            }
        });
        gone.forEach(this::drop);
    }

    private String keyOf(String port, ExportTarget target) {
        return target.isLink() ? port + " terminal " + linkOf(target).normalize()
            : port + ' ' + (target.isRfc2217() ? Rfc2217.KIND : TcpSession.RAW).getName() + ' ' + target.getNumber();
    }

    private Path linkOf(ExportTarget target) {
        return control.getFolder().toAbsolutePath().resolveSibling(FOLDER).resolve(target.getLink());
    }

    private String make(String port, ExportTarget target) throws IOException {
        if (target.isLink()) {
            Path link = linkOf(target);
            Files.createDirectories(link.getParent());
            return terminal(port, link, true);
        }
        TcpSession.Kind kind = target.isRfc2217() ? Rfc2217.KIND : TcpSession.RAW;
        return kind.getName() + " port " + tcp(port, kind, target.getNumber(), true);
    }

    private void orSay(String port, Attempt attempt) {
        try {
            attempt.run();
        } catch (IOException | RuntimeException e) {
            host.warn("the export of port " + port + " does not work: " + e.getMessage());
        }
    }

    /** An action that may fail. */
    private interface Attempt {
        void run() throws IOException;
    }

    /** Disconnects the exports before the simulation stops. */
    public synchronized void pause() {
        bridges.values().forEach(PortBridge::detach);
    }

    /** Returns the endpoints that programs open, by port name. */
    public synchronized Map<String, List<String>> list() {
        Map<String, List<String>> list = new LinkedHashMap<>();
        bridges.forEach((name, bridge) -> list.put(name, bridge.describe()));
        return list;
    }

    /**
     * Ends all exports of a port.
     *
     * @throws IllegalArgumentException with the exported ports
     */
    public synchronized void end(String port) {
        if (!bridges.containsKey(port)) {
            throw new IllegalArgumentException("port \"" + port + "\" is not exported, legal: "
                + (bridges.isEmpty() ? "none" : String.join(", ", bridges.keySet())));
        }
        bridges.remove(port).close();
        made.values().removeIf(export -> export.bridge.isEmpty());
    }

    private void drop(String key) {
        Export export = made.remove(key);
        export.bridge.remove(export.endpoint);
        if (export.bridge.isEmpty()) {
            export.bridge.close();
            bridges.values().remove(export.bridge);
        }
    }

    /** Ends all exports. */
    public synchronized void close() {
        bridges.values().forEach(PortBridge::close);
        bridges.clear();
        made.clear();
    }
}
