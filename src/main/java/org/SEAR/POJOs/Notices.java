// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.List;
import java.util.stream.Collectors;

/**
 * Notices about legal but doubtful objects: reported to the script session in use, or to the log if there is none. Any
 * thread.
 */
final class Notices {
    private static final System.Logger LOG = System.getLogger("org.SEAR.POJOs");
    /** Largest number of objects that a notice names. */
    private static final int NAMED = 5;

    private Notices() {
    }

    /**
     * Reports a new object that the running simulation ignores, or whose name the script has used before.
     *
     * @param label {@code Box "crate"}
     * @param taken whether it replaces the file of an object of the same name
     */
    static void made(String label, String name, boolean taken) {
        ScriptSession scriptSession = ScriptSessions.ALL.present();
        if (scriptSession != null && scriptSession.isSimulating()) {
            say(label + " was made while a simulation runs: it appears at the next startSimulation()");
        }
        if (ScriptSessions.ALL.script().isAgain(name, taken)) {
            say(label + " has the name of an object that this script has made already, and replaces its file: a name "
                + "means one object of the project");
        }
    }

    /**
     * Reports that a change of an object does not affect the running simulation.
     *
     * @param what the change, a participle
     * @param instead a call that takes effect immediately; empty if there is none
     * @param madeAfter number of starts before the object was created
     */
    static void changed(String label, String what, String instead, int madeAfter) {
        if (ScriptSessions.ALL.actsFor(madeAfter) != null) {
            say(label + " was " + what + " while a simulation runs: the change is in its file and takes "
                + "effect at the next startSimulation()" + instead);
        }
    }

    /**
     * Returns the notice about objects of a project that the script did not create.
     *
     * @return one line; empty if there are none
     */
    static String ofOthers(List<String> others) {
        if (others.isEmpty()) {
            return "";
        }
        String named = others.stream().limit(NAMED).map(name -> '"' + name + '"').collect(Collectors.joining(", "));
        String more = others.size() > NAMED ? " and " + (others.size() - NAMED) + " more" : "";
        return "in the project, but not made by this script: " + named + more
            + " (from an earlier run or another script; call sear.newProject() first to start with an empty project)";
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
