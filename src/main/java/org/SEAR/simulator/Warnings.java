package org.SEAR.simulator;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** What the user should know, each thing once, in the order in which it came up. Simulation thread. */
final class Warnings {
    private final Set<String> all = new LinkedHashSet<>();
    private List<String> list = List.of();

    void add(String warning) {
        if (all.add(warning)) {
            list = List.copyOf(all);
        }
    }

    /** Starts again with what is known from the start. */
    void restart(List<String> project, List<String> world, List<String> devices) {
        all.clear();
        all.addAll(project);
        all.addAll(world);
        all.addAll(devices);
        list = List.copyOf(all);
    }

    /** Immutable; the same list as long as nothing new came up. */
    List<String> list() {
        return list;
    }
}
