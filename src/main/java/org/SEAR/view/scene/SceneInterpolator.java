package org.SEAR.view.scene;

import com.jme3.math.FastMath;
import com.jme3.math.Quaternion;
import com.jme3.math.Vector3f;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import org.SEAR.geometry.Pose;
import org.SEAR.scene.SceneState;

/**
 * Turns states that arrive at uneven times into smooth motion: keeps the last few, and shows the world a little late, between the two states that
 * enclose the display's time. Window thread only.
 */
public final class SceneInterpolator {
    private static final int KEPT = 6;
    /** How far behind the newest state the display runs, real seconds: two steps. */
    private static final double DELAY = 2 / 60.0;
    /** Farther off than this, real seconds, the display jumps. */
    private static final double JUMP = 0.25;
    /** Share of the display's error that is corrected at each frame. */
    private static final double CORRECTION = 0.1;

    private final Deque<SceneState> states = new ArrayDeque<>();
    private double clock;
    private SceneState before;
    private SceneState after;
    private float share;

    /**
     * Takes the newest state and moves the display's time on.
     *
     * @param sceneState the newest; may be the same as at the last frame
     * @param speed simulated seconds per real second; 0 while paused
     * @param frameTime real seconds since the last frame
     */
    public void advance(SceneState sceneState, double speed, double frameTime) {
        SceneState last = states.peekLast();
        if (last == null || sceneState.step < last.step) {
            states.clear();
            clock = sceneState.time;
        }
        if (states.isEmpty() || sceneState.step != states.peekLast().step) {
            states.addLast(sceneState);
        }
        if (states.size() > KEPT) {
            states.removeFirst();
        }
        double target = speed > 0 ? sceneState.time - DELAY * speed : sceneState.time;
        clock += frameTime * speed;
        double error = target - clock;
        boolean far = speed <= 0 || Math.abs(error) > JUMP * speed;
        clock += far ? error : error * CORRECTION;
        clock = Math.max(states.peekFirst().time, Math.min(sceneState.time, clock));
        enclose();
    }

    private void enclose() {
        Iterator<SceneState> all = states.iterator();
        before = all.next();
        after = before;
        while (all.hasNext() && after.time < clock) {
            before = after;
            after = all.next();
        }
        double span = after.time - before.time;
        share = span > 0 ? (float) Math.max(0, Math.min(1, (clock - before.time) / span)) : 1;
    }

    /** The newest state: for numbers and words. */
    public SceneState newest() {
        return states.peekLast();
    }

    /** The state whose beams go best with the poses shown. */
    SceneState shown() {
        return share < 0.5f ? before : after;
    }

    void environment(int index, Vector3f place, Quaternion turn) {
        between(before.environment.get(index), after.environment.get(index), place, turn);
    }

    void robot(int index, Vector3f place, Quaternion turn) {
        between(before.robots.get(index).pose, after.robots.get(index).pose, place, turn);
    }

    void wheel(int robot, int wheel, Vector3f place, Quaternion turn) {
        between(before.robots.get(robot).wheels.get(wheel), after.robots.get(robot).wheels.get(wheel), place, turn);
    }

    /** @return whether a servo may turn the component: else it is where its object is */
    boolean part(int robot, int part, Vector3f place, Quaternion turn) {
        boolean known = part < before.robots.get(robot).parts.size() && part < after.robots.get(robot).parts.size();
        if (known) {
            between(before.robots.get(robot).parts.get(part), after.robots.get(robot).parts.get(part), place, turn);
        }
        return known;
    }

    private void between(Pose a, Pose b, Vector3f place, Quaternion turn) {
        place.set(FastMath.interpolateLinear(share, (float) a.x, (float) b.x), FastMath.interpolateLinear(share, (float) a.y, (float) b.y),
            FastMath.interpolateLinear(share, (float) a.z, (float) b.z));
        double sign = a.qx * b.qx + a.qy * b.qy + a.qz * b.qz + a.qw * b.qw < 0 ? -share : share;
        double rest = 1 - share;
        turn.set((float) (a.qx * rest + b.qx * sign), (float) (a.qy * rest + b.qy * sign), (float) (a.qz * rest + b.qz * sign),
            (float) (a.qw * rest + b.qw * sign));
        turn.normalizeLocal();
    }
}
