package org.SEAR.POJOs;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** What makers of objects should know, although it is legal: goes to those who listen, such as a SEAR service, else to the log. Any thread. */
public final class Notices {
    private static final System.Logger LOG = System.getLogger("org.SEAR.POJOs");
    private static final List<Consumer<String>> LISTENERS = new CopyOnWriteArrayList<>();
    private static volatile BooleanSupplier simulating = () -> false;

    private Notices() {
    }

    /**
     * Listens from now on.
     *
     * @param listener is called on the thread that makes the object
     */
    public static void listen(Consumer<String> listener) {
        LISTENERS.add(listener);
    }

    /** Ends {@link #listen}. */
    public static void leave(Consumer<String> listener) {
        LISTENERS.remove(listener);
    }

    /** Says how to find out whether a simulation runs, which has read its objects and looks at no later ones. */
    public static void setSimulating(BooleanSupplier running) {
        simulating = running;
    }

    /**
     * An object was made.
     *
     * @param label {@code Box "crate"}
     * @param taken whether there was a file of its name already
     */
    static void made(String label, String name, boolean taken) {
        if (simulating.getAsBoolean()) {
            say(label + " was made while a simulation runs: it will be there after the next startSimulation()");
        }
        if (ScriptRun.isAgain(name) && taken) {
            say(label + " has the name of an object that this script has made already, and replaces its file: a name means one object of the"
                + " project");
        }
    }

    private static void say(String text) {
        LISTENERS.forEach(one -> one.accept(text));
        if (LISTENERS.isEmpty()) {
            LOG.log(System.Logger.Level.WARNING, text);
        }
    }
}
