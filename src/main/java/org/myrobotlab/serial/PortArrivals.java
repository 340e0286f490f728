package org.myrobotlab.serial;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Who is to be connected again as soon as a simulation has a port, and gives way to whoever then asks for it himself. Any thread. */
public final class PortArrivals {
    /** By name of who waits; in the order in which they began. Guarded by itself. */
    private static final Map<String, PortUser> WAITING = new LinkedHashMap<>();
    /** Who was connected by {@link #arrived}, by name. Guarded by {@link #WAITING}. */
    private static final Map<String, PortUser> CONNECTED = new LinkedHashMap<>();

    private PortArrivals() {
    }

    /** Waits for a port; whatever the same one waited for before is forgotten. */
    public static void await(PortUser user) {
        synchronized (WAITING) {
            forget(user.name);
            WAITING.put(user.name, user);
        }
    }

    /** Ends {@link #await}, and whoever is connected has done it himself. Does nothing if he does not wait. */
    public static void forget(String who) {
        synchronized (WAITING) {
            WAITING.remove(who);
            CONNECTED.remove(who);
        }
    }

    /** Another project is opened: nobody waits for the devices of the one before. */
    public static void anotherProject() {
        synchronized (WAITING) {
            WAITING.values().removeIf(user -> user.ofThisProject);
        }
    }

    /** A port is there: whoever waits for it is connected, unless others have been quicker. */
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

    /** Somebody asks for a port that is in use: whoever was only connected again leaves it. */
    static void giveWay(String port) {
        List<PortUser> due = new ArrayList<>();
        synchronized (WAITING) {
            CONNECTED.values().removeIf(one -> one.port.equals(port) && due.add(one));
        }
        due.forEach(user -> user.leave.run());
    }
}
