package org.myrobotlab.service.sear.panel;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * What panels are told of a running world, again and again: the whole of it when it begins or is reset, from then on what has changed, so that what
 * does not move costs nothing. Messages are numbered: a panel that has missed one, or comes later, asks for the whole.
 *
 * <pre>
 * {"number": 7, "running": true, "paused": false, "lockStep": false, "speed": 1.0 (measured), "wantedSpeed": 1.0, "time": 0, "step": 0,
 *  "objects": [..], "robots": [..], "sensors": [..]}                               the whole; its lists stand at {@link WorldJson}
 * {.., "warnings": ["box has fallen out of the world .."]}                        and all warnings so far, for a panel that asked
 * {"number": 8, .., "time": 0.1, "step": 6,
 *  "changes": {"objects": {"3": {"pose": [..]}}, "robots": {"0": {"pose": [..], "speed": 0.2}}, "sensors": {}}}     by place in their list,
 *                                                                                  null for what is no longer there
 * {"running": false}                                                              there is no world
 * </pre>
 *
 * <p>Asked on the simulation thread, forgotten from any.
 */
public final class WorldFeed {
    /** Stands for "as fast as possible", which JSON has no number for. */
    private static final double FASTEST = 1e6;
    private static final double ROUNDING = 1e3;

    private final Looks looks = new Looks();
    private final WorldJson state = new WorldJson(looks);
    private long number;
    private Simulation world;
    private Map<String, Object> last;

    /** What there is to say when nothing runs. */
    public static Map<String, Object> nothing() {
        Map<String, Object> message = new LinkedHashMap<>();
        message.put("running", false);
        return message;
    }

    /** The next message for everybody: the whole of a world that has just begun, else what has changed since the last one. */
    public Map<String, Object> next(Simulation present, SimulationSession session) {
        return running(next(present), session);
    }

    public synchronized Map<String, Object> next(Simulation present) {
        Map<String, Object> now = state.moving(present);
        boolean same = present == world && (Double) now.get("time") >= (Double) last.get("time");
        Map<String, Object> before = last;
        world = present;
        last = now;
        number++;
        return numbered(same ? changes(before, now) : state.of(present));
    }

    /** The whole, for a panel that has missed something; the messages for everybody go on from its number. */
    public Map<String, Object> whole(Simulation present, SimulationSession session) {
        return running(whole(present), session);
    }

    public synchronized Map<String, Object> whole(Simulation present) {
        Map<String, Object> message = numbered(state.of(present));
        message.put("warnings", present.snapshot().warnings);
        return message;
    }

    /** What its shapes look like, as {@link Looks} tells it. */
    public List<Map<String, Object>> looks(List<String> wanted) {
        return looks.of(wanted);
    }

    /** The world has ended. */
    public synchronized void forget() {
        world = null;
        last = null;
    }

    private Map<String, Object> numbered(Map<String, Object> message) {
        message.put("number", number);
        return message;
    }

    private static Map<String, Object> running(Map<String, Object> message, SimulationSession session) {
        message.put("running", true);
        message.put("paused", session.isPaused());
        message.put("lockStep", session.isLockStep());
        message.put("speed", WorldJson.rounded(session.getMeasuredSpeed(), ROUNDING));
        message.put("wantedSpeed", Math.min(session.getWantedSpeed(), FASTEST));
        return message;
    }

    private static Map<String, Object> changes(Map<String, Object> before, Map<String, Object> now) {
        Map<String, Object> message = new LinkedHashMap<>();
        message.put("time", now.get("time"));
        message.put("step", now.get("step"));
        Map<String, Object> changes = new LinkedHashMap<>();
        WorldJson.LISTS.forEach(list -> changes.put(list, changes(WorldJson.list(before, list), WorldJson.list(now, list))));
        message.put("changes", changes);
        return message;
    }

    private static Map<Integer, Object> changes(List<Map<String, Object>> before, List<Map<String, Object>> now) {
        Map<Integer, Object> changes = new TreeMap<>();
        for (int i = 0; i < now.size(); i++) {
            Map<String, Object> old = before.get(i);
            Map<String, Object> present = now.get(i);
            Map<String, Object> changed = new LinkedHashMap<>();
            present.forEach((key, value) -> {
                if (!Objects.deepEquals(value, old.get(key))) {
                    changed.put(key, value);
                }
            });
            old.keySet().stream().filter(key -> !present.containsKey(key)).forEach(key -> changed.put(key, null));
            if (!changed.isEmpty()) {
                changes.put(i, changed);
            }
        }
        return changes;
    }
}
