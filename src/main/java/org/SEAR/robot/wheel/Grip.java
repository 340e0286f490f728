package org.SEAR.robot.wheel;

import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.SolverBody;

/**
 * The friction of one wheel on the ground: along the way in which it drives what its motor gives, across it what holds it, both together no more than
 * friction allows. Simulation thread.
 */
final class Grip {
    /** Coefficient of friction of a wheel that does not say: on a floor that does not, either, it makes 1. */
    private static final double RUBBER = 1.25;
    /** A wheel slips at this share of its friction. */
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
    /** Length of the last substep if the motor drove in it, else 0. */
    private double driven;

    /**
     * Of a wheel.
     *
     * @param across whether it grips across
     * @param carried by it, kg
     */
    Grip(Wheel wheel, boolean across, double carried) {
        tyre = wheel.getFriction() == null ? RUBBER : wheel.getFriction();
        this.across = across;
        holding = new Brush(forward, carried);
        sideways = new Brush(side, carried);
    }

    /** @param share of its friction that it has across */
    void setSideShare(double share) {
        sideShare = share;
    }

    /** @param damping with which it resists being moved across, instead of holding, N s/m; 0: it holds */
    void setScrubbing(double damping) {
        scrubbing = damping;
    }

    /** @param ground coefficient of friction of what it stands on */
    void setGround(double ground) {
        friction = tyre * ground;
    }

    /** Coefficient of friction of the wheel on the ground that it stands on, or stood on last. */
    double getFriction() {
        return friction;
    }

    /** The wheel is in the air. */
    void release() {
        holding.release();
        sideways.release();
        most = 0;
        driven = 0;
    }

    /**
     * Makes the rows of a substep.
     *
     * @param driving along which the wheel drives, world frame
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

    /** The motor begins with what it gave in the last substep: wheels that were solved first would drive the more, and turn the robot. */
    private void driveOn(SolverBody body) {
        forward.impulse *= driven > 0 ? body.seconds() / driven : 0;
        driven = body.seconds();
        forward.applyImpulse(body.v, forward.impulse);
    }

    /**
     * One pass of the solver.
     *
     * @param motor that turns the wheel; null for none
     * @param v velocities of the centre of mass, changed
     * @param pressed impulse with which the ground carries the wheel, Ns
     */
    void solve(WheelMotor motor, double[] v, double pressed, double seconds) {
        most = friction * pressed;
        if (motor != null) {
            drive(motor, v, seconds);
        }
        if (across && scrub > 0) {
            side.add(v, -(sliding(v) + scrub * side.impulse) / (side.mobility + scrub), -sideShare * most, sideShare * most);
        } else if (across) {
            sideways.solve(v, sliding(v), sideShare * most);
        }
        limit(v);
        rolling = rolling(v);
        sliding = sliding(v);
    }

    private void drive(WheelMotor motor, double[] v, double seconds) {
        mostHeld = Math.min(most, motor.holding(seconds));
        if (holds) {
            holding.solve(v, rolling(v), mostHeld);
        } else {
            motor.solve(forward, v, rolling(v), most, seconds);
        }
    }

    private double sliding(double[] v) {
        return side.speed(v);
    }

    /** Both together are within a circle; those of a wheel that scrubs are each within its own limit. */
    private void limit(double[] v) {
        double beside = sideShare < 1 ? 0 : side.impulse;
        double used = most > 0 ? Math.hypot(forward.impulse, beside) / most : 1;
        slips = used >= SLIPS;
        if (used > 1) {
            forward.add(v, forward.impulse / used - forward.impulse, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
            side.add(v, side.impulse / used - side.impulse, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
        }
    }

    /**
     * Takes notice of what a substep came to.
     *
     * @param length over which the tyre forgets, metres
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

    /** How fast the wheel rolls over the ground, m/s. */
    double rolling(double[] v) {
        return forward.speed(v);
    }

    /** The same as the last pass has left it. */
    double rolling() {
        return rolling;
    }

    /** How fast it slides over the ground to its left, as the last pass has left it, m/s. */
    double sliding() {
        return sliding;
    }

    /** Whether the motor holds the wheel, so that it does not turn. */
    boolean holds() {
        return holds && Math.abs(forward.impulse) < SLIPS * mostHeld;
    }

    /** Whether it slips. */
    boolean slips() {
        return slips;
    }

    /** The impulse along the way in which it drives, Ns. */
    double driving() {
        return forward.impulse;
    }
}
