package org.myrobotlab.service.sear.run;

import java.util.Collection;
import java.util.HashSet;
import java.util.Set;
import org.SEAR.POJOs.ScriptSession;
import org.SEAR.grammar.ScriptLine;
import org.myrobotlab.service.sear.Host;

/** Tells the user each warning of a simulation once. Any thread. */
final class ReportedWarnings {
    private static final String ORDERED = " can't obey the command to ";

    private final Host host;
    private final Set<String> reported = new HashSet<>();
    private volatile String order = "";

    ReportedWarnings(Host host) {
        this.host = host;
    }

    /** A script, the caller, gives an order. */
    void ordered() {
        order = ScriptLine.here();
    }

    /** The simulation ends before a robot can have obeyed its first order, which stands in this line. */
    void reportOfNoTime(String line) {
        host.warn(ScriptLine.added("the simulation ends at the very moment at which a robot was told to drive, so that it has not moved: an order"
            + " returns at once, and sear.simSleep(seconds) behind it lets time pass", line));
    }

    /** What has just come up. */
    void report(String warning) {
        if (!warning.isEmpty()) {
            host.warn(warning);
        }
    }

    /** Tells those that have not been told. */
    synchronized void report(Collection<String> warnings) {
        for (String warning : warnings) {
            if (reported.add(warning)) {
                host.warn(ScriptLine.added(warning, warning.contains(ORDERED) ? order : ScriptSession.lineOf(warning)));
            }
        }
    }

    /** What happens again is told again, but for these. */
    synchronized void forgetAllBut(Collection<String> warnings) {
        reported.retainAll(warnings);
    }
}
