package org.myrobotlab.service.sear.panel;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * What panels are told of a running world, again and again: the whole of it when it begins or is reset, from then on what has changed, so that what
 * does not move costs nothing. Messages are numbered: a panel that has missed one, or comes later, asks for the whole.
 *
 * <p>Asked on the simulation thread, forgotten from any.
 */
public final class WorldFeed {
    /** Stands for "as fast as possible", which JSON has no number for. */
    private static final double FASTEST = 1e6;
    private static final double ROUNDING = 1e3;

    private final LookTable looks = new LookTable();
    private final WorldJson state = new WorldJson(looks);
    private long number;
    private Simulation world;
    private WorldState last;

    /** What there is to say when nothing runs. */
    public static Map<String, Object> nothing() {
        return Map.of("running", false);
    }

    /** The next message for everybody: the whole of a world that has just begun, else what has changed since the last one. */
    public Map<String, Object> next(Simulation present, SimulationSession session) {
        return next(present, new Message(session));
    }

    synchronized Map<String, Object> next(Simulation present, Message message) {
        WorldState now = state.moving(present, new WorldState());
        if (present == world && now.time >= last.time) {
            message.changed(last, now);
        } else {
            state.whole(present, message);
        }
        world = present;
        last = now;
        message.number = ++number;
        return message.map();
    }

    /** The whole, for a panel that has missed something; the messages for everybody go on from its number. */
    public Map<String, Object> whole(Simulation present, SimulationSession session) {
        return whole(present, new Message(session));
    }

    synchronized Map<String, Object> whole(Simulation present, Message message) {
        state.whole(present, message);
        message.number = number;
        message.warnings = present.snapshot().warnings;
        return message.map();
    }

    /** What its shapes look like, as {@link LookTable} tells it. */
    public List<Map<String, Object>> looks(List<String> wanted) {
        return looks.of(wanted);
    }

    /** The world has ended. */
    public synchronized void forget() {
        world = null;
        last = null;
    }

    /** What a panel gets: the whole state, or the changes. */
    static final class Message extends WorldState {
        /** Instead of the objects, robots and sensors. */
        Changes changes;
        long number;
        /** All so far, for a panel that has asked for the whole. */
        List<String> warnings;
        Boolean running;
        Boolean paused;
        Boolean lockStep;
        /** Simulated seconds in one, as measured. */
        Double speed;
        Double wantedSpeed;

        /** Without what a session tells. */
        Message() {
        }

        Message(SimulationSession session) {
            running = true;
            paused = session.isPaused();
            lockStep = session.isLockStep();
            speed = WorldJson.rounded(session.getMeasuredSpeed(), ROUNDING);
            wantedSpeed = Math.min(session.getWantedSpeed(), FASTEST);
        }

        private void changed(WorldState before, WorldState now) {
            time = now.time;
            step = now.step;
            changes = new Changes(before, now);
            objects = null;
            robots = null;
            sensors = null;
        }
    }

    /** What is otherwise than it was: by place in the list, then by name of the field; null for what is no longer there. */
    private static final class Changes extends JsonForm {
        final Map<Integer, Object> objects;
        final Map<Integer, Object> robots;
        final Map<Integer, Object> sensors;

        Changes(WorldState before, WorldState now) {
            objects = between(before.objects, now.objects);
            robots = between(before.robots, now.robots);
            sensors = between(before.sensors, now.sensors);
        }

        private static Map<Integer, Object> between(List<? extends JsonForm> before, List<? extends JsonForm> now) {
            Map<Integer, Object> changes = new TreeMap<>();
            for (int i = 0; i < now.size(); i++) {
                Map<String, Object> changed = now.get(i).since(before.get(i));
                if (!changed.isEmpty()) {
                    changes.put(i, changed);
                }
            }
            return changes;
        }
    }
}
