// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.io.File;
import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import org.myrobotlab.service.Serial;

/** Adds virtual ports to MyRobotLab's Serial service, whose table of ports has no public access. Any thread. */
public final class SerialDeviceFactory {
    private static final String PORTS = "ports";
    private static final String PORT_NAMES = "portNames";

    /** The Serial service's table of ports. Guarded by that class. */
    private static Map<String, Port> table;

    private SerialDeviceFactory() {
    }

    /**
     * Adds a port. Closes and replaces one of the same name, so that a script can run again.
     *
     * @throws IllegalStateException if the name belongs to a running simulation, or to a real port that is open
     */
    public static void add(VirtualSerialPort port) {
        synchronized (Serial.class) {
            Port old = ports().get(port.getName());
            if (old == port) {
                return;
            }
            if (old != null) {
                refuseIfTaken(old);
                old.close();
            }
            ports().put(port.getName(), port);
        }
    }

    private static void refuseIfTaken(Port old) {
        String owner = old instanceof VirtualSerialPort ? ((VirtualSerialPort) old).getOwner() : null;
        if (owner != null) {
            throw new IllegalStateException("port " + old.getName() + " belongs to " + owner
                + ": choose another name or stop the simulation first");
        }
        if (old.isHardware() && old.isOpen()) {
            throw new IllegalStateException("port " + old.getName() + " is a real port in use: disconnect() it or "
                + "choose another name");
        }
    }

    /** Closes and removes a port. Does nothing if the table does not contain it. */
    public static void remove(VirtualSerialPort port) {
        port.unplug();
        port.close();
        synchronized (Serial.class) {
            if (ports().remove(port.getName(), port)) {
                portNames().remove(port.getName());
            }
        }
    }

    /** Finds a port, real or virtual, that was ever opened or added; null if there is none. */
    public static Port get(String name) {
        synchronized (Serial.class) {
            return ports().get(name);
        }
    }

    /** Whether a name is known only from a failed attempt to open it, or from an adapter that is unplugged. */
    public static boolean isGone(String name) {
        Port port = get(name);
        return port != null && port.isHardware() && !port.isOpen() && !port.getPortNames().contains(name)
            && !new File(name).exists();
    }

    /** Returns all virtual ports. */
    public static List<VirtualSerialPort> getVirtualPorts() {
        List<VirtualSerialPort> found = new ArrayList<>();
        synchronized (Serial.class) {
            for (Port port : ports().values()) {
                if (port instanceof VirtualSerialPort) {
                    found.add((VirtualSerialPort) port);
                }
            }
        }
        return found;
    }

    @SuppressWarnings("unchecked")
    private static Map<String, Port> ports() {
        if (table == null) {
            table = (Map<String, Port>) tableOf(PORTS);
        }
        return table;
    }

    @SuppressWarnings("unchecked")
    private static Collection<String> portNames() {
        return (Collection<String>) tableOf(PORT_NAMES);
    }

    private static Object tableOf(String name) {
        try {
            Field field = Serial.class.getDeclaredField(name);
            field.setAccessible(true);
            return field.get(null);
        } catch (ReflectiveOperationException | RuntimeException e) {
            throw new IllegalStateException("the Serial service of this MyRobotLab has no table \"" + name
                + "\"; SEAR needs Nixie 1.1", e);
        }
    }
}
