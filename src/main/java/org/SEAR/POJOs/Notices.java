package org.SEAR.POJOs;

import java.util.Collection;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/** What makers of objects should know, although it is legal: goes to those who listen, such as a SEAR service, else to the log. Any thread. */
public final class Notices {
    private static final System.Logger LOG = System.getLogger("org.SEAR.POJOs");
    private static final List<Consumer<String>> LISTENERS = new CopyOnWriteArrayList<>();
    /** Of more objects only the number is told. */
    private static final int NAMED = 5;
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
     * @param taken whether it replaces the file of an object of its name
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

    /** Another project, maybe an empty one, is in the place of the one whose objects were made until now. */
    public static void anotherProject() {
        ScriptRun.forget();
    }

    /** The calling script has opened a project or taken something out of one, and means to have what is in it. */
    public static void projectTaken() {
        ScriptRun.hasTaken();
    }

    /**
     * Which objects the calling script, which has made others, did not make: of an earlier run, as the file of an object that was renamed, or of
     * another script.
     *
     * @param names of the project's objects and robots
     * @return one line; empty if there are none
     */
    public static String ofOthers(Collection<String> names) {
        List<String> others = ScriptRun.others(names);
        if (others.isEmpty()) {
            return "";
        }
        String named = others.stream().limit(NAMED).map(name -> '"' + name + '"').collect(Collectors.joining(", "));
        String more = others.size() > NAMED ? " and " + (others.size() - NAMED) + " more" : "";
        return "in the project, but not made by this script: " + named + more + " (of an earlier run or another script; with sear.newProject() at its"
            + " beginning a script starts with an empty project)";
    }

    static void say(String text) {
        LISTENERS.forEach(one -> one.accept(text));
        if (LISTENERS.isEmpty()) {
            LOG.log(System.Logger.Level.WARNING, text);
        }
    }
}
