// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Services to be reconnected when a simulation provides their port. A reconnected service gives its port up to another
 * service that requests it. Any thread.
 */
public final class PortArrivals {
    /** Waiting services by name, in order of waiting. Guarded by itself. */
    private static final Map<String, PortUser> WAITING = new LinkedHashMap<>();
    /** Services reconnected by {@link #arrived}, by name. Guarded by {@link #WAITING}. */
    private static final Map<String, PortUser> CONNECTED = new LinkedHashMap<>();

    private PortArrivals() {
    }

    /** Waits for a port; replaces an earlier wait of the same service. */
    public static void await(PortUser user) {
        synchronized (WAITING) {
            forget(user.name);
            WAITING.put(user.name, user);
        }
    }

    /**
     * Ends {@link #await}; if the service is connected, it counts as connected by itself. Does nothing for an unknown
     * service.
     */
    public static void forget(String who) {
        synchronized (WAITING) {
            WAITING.remove(who);
            CONNECTED.remove(who);
        }
    }

    /** Ends the waits for the last project's devices when another project is opened. */
    public static void anotherProject() {
        synchronized (WAITING) {
            WAITING.values().removeIf(user -> user.ofThisProject);
        }
    }

    /** Connects the services that wait for a port, unless the port is in use already. */
    public static void arrived(VirtualSerialPort port) {
        List<PortUser> due = new ArrayList<>();
        synchronized (WAITING) {
            if (!port.isInUse()) {
                WAITING.values().removeIf(one -> one.port.equals(port.getName()) && due.add(one));
            }
        }
        for (PortUser user : due) {
            user.connect.run();
            synchronized (WAITING) {
                CONNECTED.put(user.name, user);
            }
        }
    }

    /** Disconnects a merely reconnected service from a port that another service requests. */
    static void giveWay(String port) {
        List<PortUser> due = new ArrayList<>();
        synchronized (WAITING) {
            CONNECTED.values().removeIf(one -> one.port.equals(port) && due.add(one));
        }
        due.forEach(user -> user.leave.run());
    }
}
