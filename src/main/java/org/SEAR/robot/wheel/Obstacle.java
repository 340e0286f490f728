// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.geometry.TimeStep;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.SolverBody;
import org.SEAR.raycast.Hit;

/**
 * Steep obstacle in front of a wheel at axle height, too steep to roll up. A movable one yields when pushed. Simulation
 * thread.
 */
public final class Obstacle {
    /** Radius of the cylinder that keeps a wheel out of walls, as a share of the wheel's. */
    public static final double GUARD = 0.8;
    /**
     * Horizontal coefficient of friction of the tread at an obstacle, so that a robot does not turn off a wall that it
     * pushes.
     */
    private static final double TREAD = 0.3;
    private static final double MIN_LEVEL = 0.1;
    /** Vertical part of the normal below which a surface is a wall. */
    private static final double STEEPEST = 0.35;
    /** Rate of the position correction, 1/s. */
    private static final double CORRECTION = 12;
    /**
     * Distance by which the wheel's stop is behind its guard, metres: at tall obstacles the guard acts, at steps the
     * wheel.
     */
    private static final double BEHIND_GUARD = 1e-3;
    /** Gap at which a sleeping obstacle wakes, metres, in addition to the wheel's motion in this many steps. */
    private static final double AT_HAND = 2e-3;
    private static final int STEPS_AHEAD = 2;

    /** Normal towards the wheel, world frame. */
    public final Vec3 normal = new Vec3();
    /** Contact point of the wheel, world frame. */
    public final Vec3 point = new Vec3();
    private final ConstraintRow block = new ConstraintRow();
    private final ConstraintRow slide = new ConstraintRow();
    private final Hit hit = new Hit();
    private Body body;
    private double seen;
    private double allowed;
    /** Impulse of this step before the present substep, N s. */
    private double given;

    /**
     * Finds the obstacle, once per step.
     * @param from the wheel's centre, world frame
     * @param way rolling direction
     * @param speed present or commanded speed along it, m/s, + forward, 0 at rest
     * @param owner number of the robot, whose parts are not obstacles
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
        double distance = scenes.ground.cast(from.x, from.y, from.z, sign * way.x, sign * way.y, sign * way.z, range,
            owner, hit);
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
        allowed = allowed(room, robot.seconds());
    }

    /** Returns the least speed away from a surface that uses up the room before it, or corrects an overlap, m/s. */
    static double allowed(double room, double seconds) {
        return room > 0 ? -room / seconds : -CORRECTION * room;
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

    /** Obstacle; null if there is none. */
    public Body body() {
        return body;
    }

    /** Whether the wheel presses against it. */
    public boolean isPressed() {
        return body != null && given + block.impulse > 0;
    }
}
