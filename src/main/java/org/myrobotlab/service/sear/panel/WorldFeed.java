// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * Messages about a running world for panels: the whole state at the start and after a reset, then only changes.
 * Messages are numbered; a panel that missed one or starts later requests the whole state.
 *
 * <p>Call on the simulation thread, {@link #forget} on any.
 */
public final class WorldFeed {
    /** Number for "as fast as possible", because JSON has no infinity. */
    private static final double FASTEST = 1e6;
    private static final double ROUNDING = 1e3;

    private final LookTable looks = new LookTable();
    private final WorldJson state = new WorldJson(looks);
    private long number;
    private Simulation world;
    private WorldState last;

    /** Returns the message while nothing runs. */
    public static Map<String, Object> nothing() {
        return Map.of("running", false);
    }

    /**
     * Returns the next message to all panels: the whole state of a new world, else the changes since the last message.
     */
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

    /**
     * Returns the whole state for one panel. Carries the number of the last message, so that the next message follows
     * it.
     */
    public Map<String, Object> whole(Simulation present, SimulationSession session) {
        return whole(present, new Message(session));
    }

    synchronized Map<String, Object> whole(Simulation present, Message message) {
        state.whole(present, message);
        message.number = number;
        message.warnings = present.snapshot().warnings;
        return message.map();
    }

    /** Returns looks of the world's shapes, see {@link LookTable#of}. */
    public List<Map<String, Object>> looks(List<String> wanted) {
        return looks.of(wanted);
    }

    /** Forgets a world that has ended. */
    public synchronized void forget() {
        world = null;
        last = null;
    }

    /** A message: the whole state, or the changes. */
    static final class Message extends WorldState {
        /** Present instead of objects, robots, sensors and joints. */
        Changes changes;
        long number;
        /** All warnings so far, only in a whole state on request. */
        List<String> warnings;
        Boolean running;
        Boolean paused;
        Boolean lockStep;
        /** Measured simulated seconds per second. */
        Double speed;
        Double wantedSpeed;

        /** Creates a message without a session's fields. */
        Message() {
        }

        Message(SimulationSession session) {
            running = true;
            paused = session.isPaused();
            lockStep = session.isLockStep();
            speed = JsonNumbers.rounded(session.getMeasuredSpeed(), ROUNDING);
            wantedSpeed = Math.min(session.getWantedSpeed(), FASTEST);
        }

        private void changed(WorldState before, WorldState now) {
            time = now.time;
            step = now.step;
            changes = new Changes(before, now);
            objects = null;
            robots = null;
            sensors = null;
            joints = null;
        }
    }

    /** Changed fields: by index in the list, then by field name; null for a field without a value now. */
    private static final class Changes extends JsonForm {
        final Map<Integer, Object> objects;
        final Map<Integer, Object> robots;
        final Map<Integer, Object> sensors;
        final Map<Integer, Object> joints;

        Changes(WorldState before, WorldState now) {
            objects = between(before.objects, now.objects);
            robots = between(before.robots, now.robots);
            sensors = between(before.sensors, now.sensors);
            joints = between(before.joints, now.joints);
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
