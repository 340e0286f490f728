// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.devices.RepeatedWarnings;

/** Warnings for the user, one per cause, in order of appearance. Simulation thread. */
final class SimulationWarnings {
    /** Suffix of the key under which the count of a cause is stored. */
    private static final String COUNTED = " counted";

    private final Map<String, String> byCause = new LinkedHashMap<>();
    private final RepeatedWarnings repeats = new RepeatedWarnings();
    private List<String> list = List.of();

    /** Adds a warning about a state; repetitions are ignored. */
    void add(String warning) {
        if (byCause.putIfAbsent(warning, warning) == null) {
            list = List.copyOf(byCause.values());
        }
    }

    /**
     * Adds a warning about an event. The first one of its cause stays, followed by one with the count, see
     * {@link RepeatedWarnings}.
     */
    void count(String cause, String warning) {
        String text = repeats.count(cause, warning);
        if (text != null) {
            byCause.put(byCause.containsKey(cause) ? cause + COUNTED : cause, text);
            list = List.copyOf(byCause.values());
        }
    }

    /** Clears all warnings and adds those known at the start. */
    void restart(List<String> project, List<String> world, List<String> devices) {
        byCause.clear();
        repeats.clear();
        project.forEach(this::add);
        world.forEach(this::add);
        devices.forEach(this::add);
        list = List.copyOf(byCause.values());
    }

    /** Immutable; the same list until a warning is added. */
    List<String> list() {
        return list;
    }
}
