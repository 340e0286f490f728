package org.myrobotlab.serial;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Who is to be connected again as soon as a simulation has a port. Any thread. */
public final class PortArrivals {
    /** By name of who waits; in the order in which they began. Guarded by itself. */
    private static final Map<String, Waiting> WAITING = new LinkedHashMap<>();

    private static final class Waiting {
        private final String port;
        private final Runnable connect;

        Waiting(String port, Runnable connect) {
            this.port = port;
            this.connect = connect;
        }
    }

    private PortArrivals() {
    }

    /**
     * Waits for a port; whatever the same one waited for before is forgotten.
     *
     * @param connect run once when the port has come, on the thread that brings it
     */
    public static void await(String who, String port, Runnable connect) {
        synchronized (WAITING) {
            WAITING.remove(who);
            WAITING.put(who, new Waiting(port, connect));
        }
    }

    /** Ends {@link #await}. Does nothing if he does not wait. */
    public static void forget(String who) {
        synchronized (WAITING) {
            WAITING.remove(who);
        }
    }

    /** A port is there: whoever waits for it is connected. */
    public static void arrived(String port) {
        List<Runnable> due = new ArrayList<>();
        synchronized (WAITING) {
            WAITING.values().removeIf(one -> one.port.equals(port) && due.add(one.connect));
        }
        due.forEach(Runnable::run);
    }
}
