// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.util.Collection;
import java.util.HashSet;
import java.util.Set;
import org.SEAR.POJOs.ScriptSession;
import org.SEAR.grammar.ScriptLine;
import org.myrobotlab.service.sear.Host;

/** Reports each warning of a simulation once. Any thread. */
final class ReportedWarnings {
    private static final String ORDERED = " can't obey the command to ";

    private final Host host;
    private final Set<String> reported = new HashSet<>();
    private volatile String order = "";

    ReportedWarnings(Host host) {
        this.host = host;
    }

    /** Records the script line of the present command. */
    void ordered() {
        order = ScriptLine.here();
    }

    /** Warns that the simulation ends before a robot could run its first command, which is in the given line. */
    void reportOfNoTime(String line) {
        host.warn(ScriptLine.added("the simulation ends immediately after a drive command, so that the robot has not "
            + "moved: a command returns immediately; call sear.simSleep(seconds) after it to let time pass", line));
    }

    /** Reports a new warning; does nothing for an empty text. */
    void report(String warning) {
        if (!warning.isEmpty()) {
            host.warn(warning);
        }
    }

    /** Reports the warnings that have not been reported yet. */
    synchronized void report(Collection<String> warnings) {
        for (String warning : warnings) {
            if (reported.add(warning)) {
                host.warn(ScriptLine.added(warning, warning.contains(ORDERED) ? order : ScriptSession.lineOf(warning)));
            }
        }
    }

    /** Makes all warnings reportable again except the given ones. */
    synchronized void forgetAllBut(Collection<String> warnings) {
        reported.retainAll(warnings);
    }
}
