// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.Snapshot;

/**
 * Interpolates between steps for smooth motion from states that arrive at irregular times. Keeps the latest states and
 * shows the world with a small delay, between the two states around the display time. One thread.
 */
public final class Movement {
    private static final int KEPT = 6;
    /** Delay of the display behind the newest state, real seconds: two steps. */
    private static final double DELAY = 2 / 60.0;
    /** Display error above which the display time jumps, real seconds. */
    private static final double JUMP = 0.25;
    /** Share of the display error corrected per frame. */
    private static final double CORRECTION = 0.1;
    /** A body that moves further than this, metres, and faster than this, m/s, has been teleported. */
    private static final double FAR = 1;
    private static final double FASTEST = 60;

    private final Deque<Snapshot> states = new ArrayDeque<>();
    private double clock;
    private Snapshot before;
    private Snapshot after;
    private double share;

    /**
     * Adds the newest state and advances the display time.
     * @param snapshot the newest state; may equal that of the last frame
     * @param speed simulated seconds per real second; 0 while paused
     * @param frameTime real seconds since the last frame
     */
    public void advance(Snapshot snapshot, double speed, double frameTime) {
        Snapshot last = states.peekLast();
        if (last == null || snapshot.step < last.step) {
            states.clear();
            clock = snapshot.time;
        }
        if (states.isEmpty() || snapshot.step != states.peekLast().step) {
            states.addLast(snapshot);
        }
        if (states.size() > KEPT) {
            states.removeFirst();
        }
        double target = speed > 0 ? snapshot.time - DELAY * speed : snapshot.time;
        clock += frameTime * speed;
        double error = target - clock;
        boolean far = speed <= 0 || Math.abs(error) > JUMP * speed;
        clock += far ? error : error * CORRECTION;
        clock = Math.max(states.peekFirst().time, Math.min(snapshot.time, clock));
        enclose();
    }

    private void enclose() {
        Iterator<Snapshot> all = states.iterator();
        before = all.next();
        after = before;
        while (all.hasNext() && after.time < clock) {
            before = after;
            after = all.next();
        }
        double span = after.time - before.time;
        share = span > 0 ? Math.max(0, Math.min(1, (clock - before.time) / span)) : 1;
    }

    /** Returns the newest state, for numbers and text. */
    public Snapshot newest() {
        return states.peekLast();
    }

    /** Returns the state whose beams and lights best match the displayed poses. */
    public Snapshot shown() {
        return share < 0.5 ? before : after;
    }

    public Pose environment(int index) {
        return between(before.environment.get(index), after.environment.get(index));
    }

    public Pose robot(int index) {
        return between(before.robots.get(index).pose, after.robots.get(index).pose);
    }

    /** Returns a wheel's pose in the robot's frame. */
    public Pose wheel(int robot, int wheel) {
        return between(before.robots.get(robot).wheels.get(wheel), after.robots.get(robot).wheels.get(wheel));
    }

    /**
     * Returns a component's pose in the robot's frame. Returns null if no servo can turn any: the component is at its
     * object's pose.
     */
    public Pose part(int robot, int part) {
        boolean known = part < before.robots.get(robot).parts.size() && part < after.robots.get(robot).parts.size();
        return known ? between(before.robots.get(robot).parts.get(part), after.robots.get(robot).parts.get(part))
            : null;
    }

    private Pose between(Pose a, Pose b) {
        return between(a, b, share, after.time - before.time);
    }

    /**
     * Interpolates between two poses: linearly in position, the shorter way in rotation (normalised linear
     * interpolation). A teleported body is at b immediately.
     * @param share 0 to 1
     * @param seconds simulated time between the poses
     */
    public static Pose between(Pose a, Pose b, double share, double seconds) {
        double dx = b.x - a.x;
        double dy = b.y - a.y;
        double dz = b.z - a.z;
        double limit = Math.max(FAR, FASTEST * seconds);
        if (share >= 1 || dx * dx + dy * dy + dz * dz > limit * limit) {
            return b;
        }
        double rest = 1 - share;
        double sign = a.qx * b.qx + a.qy * b.qy + a.qz * b.qz + a.qw * b.qw < 0 ? -share : share;
        double qx = a.qx * rest + b.qx * sign;
        double qy = a.qy * rest + b.qy * sign;
        double qz = a.qz * rest + b.qz * sign;
        double qw = a.qw * rest + b.qw * sign;
        double length = Math.sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
        return new Pose(a.x + dx * share, a.y + dy * share, a.z + dz * share, qx / length, qy / length, qz / length,
            qw / length);
    }
}
