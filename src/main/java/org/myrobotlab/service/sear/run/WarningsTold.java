package org.myrobotlab.service.sear.run;

import java.util.Collection;
import java.util.HashSet;
import java.util.Set;
import org.SEAR.POJOs.Workbench;
import org.SEAR.grammar.ScriptLine;
import org.myrobotlab.service.sear.Host;

/** Tells the user each warning of a simulation once. Any thread. */
final class WarningsTold {
    private static final String ORDERED = " was told to ";
    /** A simulation that ends so soon after an order has not obeyed it, s. */
    private static final double AT_ONCE = 0.1;

    private final Host host;
    private final Set<String> told = new HashSet<>();
    private volatile String order = "";
    private volatile double goingSince = Double.NEGATIVE_INFINITY;

    WarningsTold(Host host) {
        this.host = host;
    }

    /**
     * A script, the caller, gives an order.
     *
     * @param time at which it has set a robot going, s; negative infinity if it has not
     */
    void ordered(double time) {
        order = ScriptLine.here();
        goingSince = time;
    }

    /** The simulation ends at this moment, s: says so if the last order can't have been obeyed. */
    void tellOfNoTime(double time) {
        if (time - goingSince < AT_ONCE) {
            host.warn(ScriptLine.added("the simulation ends at the very moment at which a robot was told to drive, so that it has not moved: an order"
                + " returns at once, and sear.simSleep(seconds) behind it lets time pass", order));
        }
    }

    /** Tells those that have not been told. */
    synchronized void tell(Collection<String> warnings) {
        for (String warning : warnings) {
            if (told.add(warning)) {
                host.warn(ScriptLine.added(warning, warning.contains(ORDERED) ? order : Workbench.lineOf(warning)));
            }
        }
    }

    /** What happens again is told again, but for these. */
    synchronized void forgetAllBut(Collection<String> warnings) {
        told.retainAll(warnings);
    }
}
