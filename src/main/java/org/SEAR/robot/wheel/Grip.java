package org.SEAR.robot.wheel;

import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.SolverBody;

/**
 * The friction of one wheel on the ground: along the way in which it drives what its motor gives, across it what holds it, both together no more than
 * friction allows. Impulses start from nothing in each substep, because what several wheels hold against each other would never fade. Simulation
 * thread.
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
    private final Stick rolls = new Stick();
    private final Stick slides = new Stick();
    private final Vec3 way = new Vec3();
    private final Vec3 left = new Vec3();
    private double friction;
    private double sideShare = 1;
    private double scrubbing;
    private double scrub;
    private double groundForward;
    private double groundSide;
    private double rolling;
    private double sliding;
    private double most;
    private boolean slips;

    /** @param across whether it grips across */
    Grip(Wheel wheel, boolean across) {
        tyre = wheel.getFriction() == null ? RUBBER : wheel.getFriction();
        this.across = across;
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

    /** The wheel is in the air. */
    void release() {
        rolls.release();
        slides.release();
        forward.impulse = 0;
        side.impulse = 0;
        most = 0;
    }

    /**
     * Makes the rows of a substep.
     *
     * @param driving along which the wheel drives, world frame
     */
    void prepare(GroundContact ground, Vec3 driving, SolverBody body) {
        way.set(driving).flatten(ground.normal).normalize();
        left.cross(ground.normal, way);
        forward.set(way.x, way.y, way.z, ground.point.x, ground.point.y, ground.point.z, body);
        side.set(left.x, left.y, left.z, ground.point.x, ground.point.y, ground.point.z, body);
        groundForward = ground.speed(way.x, way.y, way.z);
        groundSide = ground.speed(left.x, left.y, left.z);
        scrub = scrubbing > 0 ? 1 / (scrubbing * body.seconds()) : 0;
        forward.impulse = 0;
        side.impulse = 0;
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
            motor.solve(forward, v, rolling(v) - (motor.holds() ? rolls.back() : 0), most, seconds);
        }
        if (across) {
            double wrong = side.speed(v) - groundSide - slides.back() + scrub * side.impulse;
            side.add(v, -wrong / (side.mobility + scrub), -sideShare * most, sideShare * most);
        }
        limit(v);
        rolling = rolling(v);
        sliding = side.speed(v) - groundSide;
    }

    /** Both together are within an ellipse. */
    private void limit(double[] v) {
        double used = most > 0 ? Math.hypot(forward.impulse, side.impulse / sideShare) / most : 1;
        slips = used >= SLIPS;
        if (used > 1) {
            forward.add(v, forward.impulse / used - forward.impulse, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
            side.add(v, side.impulse / used - side.impulse, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
        }
    }

    /**
     * Takes notice of what a substep came to.
     *
     * @param holds whether the motor holds the wheel
     * @param length over which the tyre forgets, metres
     */
    void feel(boolean holds, double length, double seconds) {
        if (slips || !holds) {
            rolls.release();
        } else {
            rolls.move(rolling * seconds);
        }
        if (slips || scrubbing > 0 || !across) {
            slides.release();
        } else {
            slides.move(sliding * seconds);
            slides.roll(rolling * seconds, length);
        }
    }

    /** How fast the wheel rolls over the ground, m/s. */
    double rolling(double[] v) {
        return forward.speed(v) - groundForward;
    }

    /** The same as the last pass has left it. */
    double rolling() {
        return rolling;
    }

    /** Whether it slips. */
    boolean slips() {
        return slips;
    }

    /** The impulse along the way in which it drives, Ns. */
    double driving() {
        return forward.impulse;
    }

    /** Takes the impulse that it gave to the wheel from another, Ns. */
    void takeFrom(Vec3 impulse) {
        impulse.add(-forward.impulse, way).add(-side.impulse, left);
    }
}
