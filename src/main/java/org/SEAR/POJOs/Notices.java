package org.SEAR.POJOs;

import java.util.List;
import java.util.stream.Collectors;

/** What makers of objects should know, although it is legal: goes to the workbench where they are made, without one to the log. Any thread. */
final class Notices {
    private static final System.Logger LOG = System.getLogger("org.SEAR.POJOs");
    /** Of more objects only the number is told. */
    private static final int NAMED = 5;

    private Notices() {
    }

    /**
     * An object was made.
     *
     * @param label {@code Box "crate"}
     * @param taken whether it replaces the file of an object of its name
     */
    static void made(String label, String name, boolean taken) {
        ScriptSession scriptSession = ScriptSessions.ALL.present();
        if (scriptSession != null && scriptSession.isSimulating()) {
            say(label + " was made while a simulation runs: it will be there after the next startSimulation()");
        }
        if (ScriptSessions.ALL.script().isAgain(name, taken)) {
            say(label + " has the name of an object that this script has made already, and replaces its file: a name means one object of the"
                + " project");
        }
    }

    /**
     * An object is not any more what it was.
     *
     * @param what was done with it
     * @param instead what does it at once; empty if nothing does
     * @param madeAfter so many starts
     */
    static void changed(String label, String what, String instead, int madeAfter) {
        if (ScriptSessions.ALL.actsFor(madeAfter) != null) {
            say(label + " was " + what + " while a simulation runs: its file says so, and the next startSimulation() finds it so" + instead);
        }
    }

    /**
     * Objects of a project that the script which starts it did not make.
     *
     * @return one line; empty if there are none
     */
    static String ofOthers(List<String> others) {
        if (others.isEmpty()) {
            return "";
        }
        String named = others.stream().limit(NAMED).map(name -> '"' + name + '"').collect(Collectors.joining(", "));
        String more = others.size() > NAMED ? " and " + (others.size() - NAMED) + " more" : "";
        return "in the project, but not made by this script: " + named + more + " (of an earlier run or another script; with sear.newProject() at its"
            + " beginning a script starts with an empty project)";
    }

    static void say(String text) {
        ScriptSession scriptSession = ScriptSessions.ALL.present();
        if (scriptSession == null) {
            LOG.log(System.Logger.Level.WARNING, text);
        } else {
            scriptSession.report(text);
        }
    }
}
