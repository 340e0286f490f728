package org.SEAR.robot.wheel;

import org.SEAR.geometry.TimeStep;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.SolverBody;
import org.SEAR.raycast.Hit;

/**
 * Something steep before a wheel at the height of its axle: it can't roll up that. What can move gives way as it is pushed. The grip across is not
 * given to it: that would be a speed of its own in the next step, before the floor has held it, and the wheel would follow instead of standing.
 * Simulation thread.
 */
public final class Obstacle {
    /** Radius of the cylinder that keeps a wheel out of walls, as a share of the wheel's. */
    public static final double GUARD = 0.8;
    /** Friction of a wheel's tread along what blocks it, level: else a robot that pushes against a wall would turn off it. */
    private static final double TREAD = 0.3;
    private static final double MIN_LEVEL = 0.1;
    /** What leans less than this (vertical part of the normal) is a wall. */
    private static final double STEEPEST = 0.35;
    /** Share of the depth that is corrected in a second. */
    private static final double CORRECTION = 12;
    /** How much later than its guard the wheel itself stops at something high, metres: the guard feels it, and the wheel stops at a step. */
    private static final double BEHIND_GUARD = 1e-3;
    /** What sleeps wakes when it is nearer than this and than the wheel comes in so many steps, metres. */
    private static final double AT_HAND = 2e-3;
    private static final int STEPS_AHEAD = 2;

    /** Of its surface, towards the wheel, world frame. */
    public final Vec3 normal = new Vec3();
    /** Of the wheel, where it meets it, world frame. */
    public final Vec3 point = new Vec3();
    private final ConstraintRow block = new ConstraintRow();
    private final ConstraintRow slide = new ConstraintRow();
    private final Hit hit = new Hit();
    private Body body;
    private double seen;
    private double allowed;
    /** Impulse of this step so far, but for the present substep, Ns. */
    private double given;

    /**
     * Looks for it, once a step.
     *
     * @param from the wheel's centre, world frame
     * @param way in which the wheel rolls
     * @param speed with which it does or is to, m/s, + forward, 0 if it stands
     * @param owner whose parts are none
     */
    void look(RaycastScenes scenes, Vec3 from, Vec3 way, double speed, double radius, int owner) {
        body = null;
        given = 0;
        block.impulse = 0;
        if (speed == 0) {
            return;
        }
        double sign = Math.signum(speed);
        double range = 2 * radius;
        double distance = scenes.ground.cast(from.x, from.y, from.z, sign * way.x, sign * way.y, sign * way.z, range, owner, hit);
        normal.set(hit.nx, hit.ny, hit.nz);
        double facing = -sign * normal.dot(way);
        if (distance >= range || facing <= 0 || Math.abs(normal.y) > STEEPEST) {
            return;
        }
        body = scenes.body(hit.shape);
        double reach = GUARD * radius - BEHIND_GUARD;
        seen = distance * facing - reach;
        point.set(from).add(-reach, normal);
        if (seen < AT_HAND + STEPS_AHEAD * TimeStep.SECONDS * Math.abs(speed)) {
            body.wake();
        }
    }

    void prepare(SolverBody robot) {
        if (body == null) {
            return;
        }
        given += block.impulse;
        SolverBody other = body.solver();
        block.set(normal.x, normal.y, normal.z, point.x, point.y, point.z, robot, other);
        block.impulse = 0;
        double level = Math.max(Math.hypot(normal.x, normal.z), MIN_LEVEL);
        slide.set(normal.z / level, 0, -normal.x / level, point.x, point.y, point.z, robot, other);
        slide.impulse = 0;
        double room = seen + robot.travel(normal.x, normal.y, normal.z, point.x, point.y, point.z);
        if (other != null) {
            room -= other.travel(normal.x, normal.y, normal.z, point.x, point.y, point.z);
            if (room < 0) {
                other.hold();
            }
        }
        allowed = room > 0 ? -room / robot.seconds() : -CORRECTION * room;
    }

    /** @param v velocities of the robot's centre of mass, changed */
    void solve(double[] v) {
        if (body == null) {
            return;
        }
        block.add(v, (allowed - block.speed(v)) / block.mobility, 0, Double.POSITIVE_INFINITY);
        double hold = TREAD * block.impulse;
        slide.add(v, -slide.speed(v) / slide.mobility, -hold, hold);
    }

    /** What stands there; null if nothing does. */
    Body body() {
        return body;
    }

    /** Whether the wheel presses against it. */
    public boolean isPressed() {
        return body != null && given + block.impulse > 0;
    }
}
