// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.SolverBody;

/**
 * Friction of one wheel on the ground: the motor's force along the driving direction and the holding force across it,
 * both within the friction circle. Simulation thread.
 */
final class Grip {
    /** Default coefficient of friction of a wheel: 1 on a default floor. */
    private static final double RUBBER = 1.25;
    /** Share of the friction limit above which a wheel slips. */
    private static final double SLIPS = 1 - 1e-9;

    private final double tyre;
    private final boolean across;
    private final ConstraintRow forward = new ConstraintRow();
    private final ConstraintRow side = new ConstraintRow();
    private final Brush holding;
    private final Brush sideways;
    private final Vec3 way = new Vec3();
    private final Vec3 left = new Vec3();
    private double friction;
    private double sideShare = 1;
    private double scrubbing;
    private double scrub;
    private double rolling;
    private double sliding;
    private double most;
    private boolean slips;
    private boolean holds;
    private double mostHeld;
    /** Length of the last substep if the motor drove in it, else 0, seconds. */
    private double driven;

    /**
     * Grip of a wheel.
     * @param across whether it grips sideways
     * @param carried load of the wheel, kg
     */
    Grip(Wheel wheel, boolean across, double carried) {
        tyre = wheel.getFriction() == null ? RUBBER : wheel.getFriction();
        this.across = across;
        holding = new Brush(forward, carried);
        sideways = new Brush(side, carried);
    }

    /** @param share of its friction that acts sideways */
    void setSideShare(double share) {
        sideShare = share;
    }

    /** @param damping against sideways motion instead of holding, N s/m; 0: it holds */
    void setScrubbing(double damping) {
        scrubbing = damping;
    }

    /** @param ground coefficient of friction of the ground */
    void setGround(double ground) {
        friction = tyre * ground;
    }

    /** Coefficient of friction on the present or last ground. */
    double getFriction() {
        return friction;
    }

    /** Releases the wheel in the air. */
    void release() {
        holding.release();
        sideways.release();
        most = 0;
        driven = 0;
    }

    /**
     * Sets up the rows of a substep.
     * @param driving direction in which the wheel drives, world frame
     * @param held whether the motor holds the wheel
     */
    void prepare(GroundContact ground, Vec3 driving, boolean held, SolverBody body) {
        way.set(driving).flatten(ground.normal).normalize();
        left.cross(ground.normal, way);
        ground.aim(forward, way, body);
        ground.aim(side, left, body);
        scrub = scrubbing > 0 ? 1 / (scrubbing * body.seconds()) : 0;
        holds = held;
        if (holds) {
            holding.prepare(body);
            driven = 0;
        } else {
            holding.letGo();
            driveOn(body);
        }
        if (across && scrub == 0) {
            sideways.prepare(body);
        } else {
            sideways.release();
        }
    }

    /** Warm starts the motor's row; otherwise wheels that are solved first would drive more and turn the robot. */
    private void driveOn(SolverBody body) {
        forward.impulse *= driven > 0 ? body.seconds() / driven : 0;
        driven = body.seconds();
        forward.applyImpulse(body.v, forward.impulse);
    }

    /**
     * Solves one pass.
     * @param motor of the wheel; null without inertia and motor
     * @param rim of the wheel
     * @param v velocities of the centre of mass, changed
     * @param pressed impulse of the ground on the wheel, N s
     */
    void solve(WheelMotor motor, Rim rim, double[] v, double pressed, double seconds) {
        most = friction * pressed;
        if (motor != null) {
            drive(motor, rim, v, seconds);
        }
        if (across && scrub > 0) {
            side.add(v, -(sliding(v) + scrub * side.impulse) / (side.mobility + scrub), -sideShare * most,
                sideShare * most);
        } else if (across) {
            sideways.solve(v, sliding(v), sideShare * most);
        }
        limit(v);
        rolling = rolling(v);
        sliding = sliding(v);
    }

    private void drive(WheelMotor motor, Rim rim, double[] v, double seconds) {
        mostHeld = Math.min(most, motor.holding(seconds));
        if (holds) {
            holding.solve(v, rolling(v), mostHeld);
        } else {
            motor.solve(forward, v, rolling(v), rim, most, seconds);
        }
    }

    private double sliding(double[] v) {
        return side.speed(v);
    }

    /** Limits both impulses to the friction circle; those of a scrubbing wheel have their own limits. */
    private void limit(double[] v) {
        double beside = sideShare < 1 ? 0 : side.impulse;
        double used = most > 0 ? Math.hypot(forward.impulse, beside) / most : 1;
        slips = used >= SLIPS;
        if (used > 1) {
            forward.add(v, forward.impulse / used - forward.impulse, Double.NEGATIVE_INFINITY,
                Double.POSITIVE_INFINITY);
            side.add(v, side.impulse / used - side.impulse, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
        }
    }

    /**
     * Ends a substep.
     * @param length relaxation length of the tyre, metres
     */
    void feel(double length, double seconds) {
        if (holds) {
            holding.bend(rolling, mostHeld);
        }
        if (across && scrub == 0) {
            sideways.bend(sliding, sideShare * most);
            sideways.roll(rolling * seconds, length);
        }
    }

    /** Returns the rolling speed over the ground, m/s. */
    double rolling(double[] v) {
        return forward.speed(v);
    }

    /** Rolling speed after the last pass, m/s. */
    double rolling() {
        return rolling;
    }

    /** Sliding speed to the wheel's left after the last pass, m/s. */
    double sliding() {
        return sliding;
    }

    /** Whether the motor holds the wheel still. */
    boolean holds() {
        return holds && Math.abs(forward.impulse) < SLIPS * mostHeld;
    }

    boolean slips() {
        return slips;
    }

    /** Impulse along the driving direction, N s. */
    double driving() {
        return forward.impulse;
    }
}
