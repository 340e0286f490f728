// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.collision.WheelTouch;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.SolverBody;
import org.SEAR.physics.WheelCast;
import org.SEAR.raycast.Hit;

/**
 * Contact of one wheel with the ground: once per step the wheel moves along its suspension until it touches, substeps
 * update the gap. Simulation thread.
 */
final class GroundContact {
    /**
     * Smallest cosine between ground normal and suspension of ground that supports a wheel; steeper ground is a wall.
     * Downward-facing normals do not support either: the robot is on its back.
     */
    private static final double STEEPEST = 0.35;
    /**
     * Cosine of full support; between both it fades. Ground in contact supports a wheel down to the second cosine.
     * Without this hysteresis a robot on its tail would hop.
     */
    private static final double CARRYING = 0.5;
    private static final double LETTING_GO = 0.3;
    /**
     * Largest penetration into a movable body, as a share of the wheel's diameter, at which the wheel stands on it.
     * Deeper overlaps, and bodies in a deep overlap, are resolved as contacts of bodies first.
     */
    private static final double DEEPEST = 0.25;
    /** Distance by which a second contact is lower at most, metres. */
    private static final double BESIDE = 3e-3;
    /** Difference of positions below which a ray and the wheel find the same ground, metres. */
    private static final double SAME = 1e-9;

    /** Ground normal and contact point, world frame. */
    final Vec3 normal = new Vec3();
    final Vec3 point = new Vec3();
    private final Vec3 from = new Vec3();
    private final Vec3 ahead = new Vec3();
    private final Wedge wedge = new Wedge();
    private final Hit hit = new Hit();
    /** Number of the ground's shape. */
    private int shape;
    private Body under;
    private boolean touches;
    private double share;
    private double lean;
    private double seen;
    private double gap;

    /**
     * Finds the ground, once per step, where the wheel will be at its end. Edges are so felt in time.
     * @param mount of the suspension, world frame, metres
     * @param lead predicted displacement of the mount in this step, at right angles to the suspension, metres
     * @param up along the suspension
     * @param rest length of the suspension up to which the wheel touches in this step, metres
     * @param length of the suspension after the last step, metres
     * @param deep whether the robot overlaps another body deeply, which may push it below the ground
     * @param owner number of the robot, whose parts are not ground
     */
    void look(RaycastScenes scenes, Vec3 mount, Vec3 lead, Vec3 up, WheelShape wheel, double rest, double length,
            boolean deep, int owner) {
        double radius = wheel.radius;
        double least = touches ? LETTING_GO : STEEPEST;
        ahead.set(mount).add(1, lead);
        WheelCast cast = scenes.wheels;
        cast.set(ahead, up, wheel.ahead, radius, wheel.half, wheel.ball);
        cast.find(-rest - BESIDE, -length - STEEPEST * radius, least, owner);
        WheelTouch touch = cast.highest(null);
        boolean touched = touch != null && touch.normal.y > 0 && -touch.height < rest;
        boolean carries = touched;
        if (deep || !touched || !touches) {
            double highest = touched ? Math.min(rest, -touch.height - SAME) : rest;
            boolean higher = isHigher(scenes, up, radius, highest, least, owner);
            carries |= higher;
            touched &= !higher;
        }
        if (touched) {
            set(touch);
        }
        stand(scenes, carries, -DEEPEST * 2 * radius);
        point.add(-1, lead);
        seen -= normal.dot(lead) / lean;
        share = touched && touch.edge ? 1 : Math.max(0, Math.min(1, (lean - STEEPEST) / (CARRYING - STEEPEST)));
        from.set(mount).add(-seen, up);
        WheelTouch second = touched && touches ? cast.highest(touch) : null;
        wedge.look(scenes, from, touch, second == null || second.height < touch.height - BESIDE ? null : second, lead);
    }

    /** Whether higher ground reaches the middle of the wheel, too high to climb, as after a fall. */
    private boolean isHigher(RaycastScenes scenes, Vec3 up, double radius, double rest, double least, int owner) {
        from.set(ahead).add(radius, up);
        double distance = scenes.ground.cast(from.x, from.y, from.z, -up.x, -up.y, -up.z, 2 * radius + rest, owner,
            hit);
        normal.set(hit.nx, hit.ny, hit.nz);
        lean = normal.dot(up);
        if (lean < 0) {
            normal.scale(-1);
            lean = -lean;
        }
        seen = distance - 2 * radius;
        point.set(from).add(-distance, up);
        shape = hit.shape;
        return seen < rest && lean > least && normal.y > 0;
    }

    private void set(WheelTouch touch) {
        normal.set(touch.normal);
        point.set(touch.point);
        lean = touch.lean;
        seen = -touch.height;
        shape = touch.shape;
    }

    /** @param deepest length of the suspension up to which a movable body is ground, metres */
    private void stand(RaycastScenes scenes, boolean carries, double deepest) {
        under = carries ? scenes.body(shape) : null;
        touches = under != null && (under.isFixed() || seen > deepest && !under.isDeep());
        if (touches) {
            under.wake();
        } else {
            under = null;
        }
    }

    /** Second contact of the wheel. */
    Wedge wedge() {
        return wedge;
    }

    /** Returns the ground's coefficient of friction. */
    double friction(RaycastScenes scenes) {
        return scenes.solid(shape).getSurface().friction(under.isRobot());
    }

    /** Updates the gap along the normal for a substep. */
    void prepare(SolverBody body) {
        if (carrier() != null) {
            carrier().hold();
        }
        gap = seen * lean + travel(body);
    }

    private double travel(SolverBody body) {
        double travel = body.travel(normal.x, normal.y, normal.z, point.x, point.y, point.z);
        SolverBody carrier = carrier();
        return carrier == null ? travel
            : travel - carrier.travel(normal.x, normal.y, normal.z, point.x, point.y, point.z);
    }

    /** Returns the length of the suspension after the step, metres; negative beyond full compression. */
    double reached(SolverBody body) {
        return seen + travel(body) / lean - wedge.lift(body);
    }

    /** Returns the supporting body if it moves; else null. */
    private SolverBody carrier() {
        return under.solver();
    }

    /** Sets up a row of the wheel at this contact along a direction. */
    void aim(ConstraintRow row, Vec3 along, SolverBody body) {
        row.set(along.x, along.y, along.z, point.x, point.y, point.z, body, carrier());
    }

    boolean touches() {
        return touches;
    }

    /** Share of the suspension force that the ground takes, 0 to 1, by its slope. */
    double share() {
        return share;
    }

    /**
     * Length of the suspension at which the wheel just touches the ground at the start of the step, metres; negative:
     * beyond full compression.
     */
    double seen() {
        return seen;
    }

    /** The same times {@link #lean}: the distance along the normal, updated for this substep. */
    double gap() {
        return gap;
    }

    /** Cosine between the normal and the suspension. */
    double lean() {
        return lean;
    }

    /** Supporting body; null in the air. */
    Body under() {
        return under;
    }
}
