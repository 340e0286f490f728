package org.myrobotlab.service.sear.run;

import java.util.Collection;
import java.util.HashSet;
import java.util.Set;
import org.myrobotlab.service.sear.Host;

/** Tells the user each warning of a simulation once. Any thread. */
final class WarningsTold {
    private final Host host;
    private final Set<String> told = new HashSet<>();

    WarningsTold(Host host) {
        this.host = host;
    }

    /** Tells those that have not been told. */
    synchronized void tell(Collection<String> warnings) {
        for (String warning : warnings) {
            if (told.add(warning)) {
                host.warn(warning);
            }
        }
    }

    /** What happens again is told again, but for these. */
    synchronized void forgetAllBut(Collection<String> warnings) {
        told.retainAll(warnings);
    }
}
