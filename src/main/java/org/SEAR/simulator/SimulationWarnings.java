package org.SEAR.simulator;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.devices.RepeatedWarnings;

/** What the user should know, each cause once, in the order in which it came up. Simulation thread. */
final class SimulationWarnings {
    /** Ends the key of how many of a cause there were. */
    private static final String COUNTED = " counted";

    private final Map<String, String> byCause = new LinkedHashMap<>();
    private final RepeatedWarnings repeats = new RepeatedWarnings();
    private List<String> list = List.of();

    /** Something that is so: said once, however often it is said. */
    void add(String warning) {
        if (byCause.putIfAbsent(warning, warning) == null) {
            list = List.copyOf(byCause.values());
        }
    }

    /** Something that has happened: the first of its cause stays, beside it stands how many there were, see {@link RepeatedWarnings}. */
    void count(String cause, String warning) {
        String text = repeats.count(cause, warning);
        if (text != null) {
            byCause.put(byCause.containsKey(cause) ? cause + COUNTED : cause, text);
            list = List.copyOf(byCause.values());
        }
    }

    /** Starts again with what is known from the start. */
    void restart(List<String> project, List<String> world, List<String> devices) {
        byCause.clear();
        repeats.clear();
        project.forEach(this::add);
        world.forEach(this::add);
        devices.forEach(this::add);
        list = List.copyOf(byCause.values());
    }

    /** Immutable; the same list as long as nothing new came up. */
    List<String> list() {
        return list;
    }
}
