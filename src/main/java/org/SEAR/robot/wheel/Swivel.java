package org.SEAR.robot.wheel;

import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.TimeStep;
import org.SEAR.geometry.Vec3;

/**
 * Where a wheel points that does not just point ahead: one that is steered, turns freely as a caster, has rollers, or whose axle is turned. Angles
 * are radians about the body's up axis, + to the left. Simulation thread.
 */
final class Swivel {
    /** Slower than this the way of a caster has no direction, m/s. */
    private static final double MIN_SPEED = 1e-6;

    private final double mountX;
    private final double mountZ;
    private final double home;
    private final double rollers;
    private final double trail;
    private final boolean slides;
    private double heading;
    /** The wheel's centre in the body frame, metres. */
    private double x;
    private double z;
    /** The way in which it rolls, and along which it drives and brakes, in the world. */
    private final Vec3 rolling = new Vec3();
    private final Vec3 driving = new Vec3();

    private Swivel(Wheel wheel) {
        mountX = wheel.getX();
        mountZ = wheel.getZ();
        home = Math.toRadians(wheel.getRy());
        trail = wheel.getTrail();
        slides = wheel.getRollers() != null;
        rollers = slides ? Math.toRadians(wheel.getRollers()) : 0;
        point(home);
    }

    /** That of a wheel; null for one that just points ahead. */
    static Swivel of(Wheel wheel) {
        boolean plain = !wheel.isSteered() && wheel.getTrail() == 0 && wheel.getRollers() == null && wheel.getRy() == 0;
        return plain ? null : new Swivel(wheel);
    }

    private void point(double newHeading) {
        heading = newHeading;
        x = mountX - trail * Math.sin(heading);
        z = mountZ - trail * Math.cos(heading);
    }

    /** @param angle from where it points unsteered */
    void steer(double angle) {
        point(home + angle);
    }

    /**
     * A caster has no moment of its own, so it turns as if on rails: what the point where it touches moves across it turns the wheel, and the wheel
     * rolls without slipping. Within a step, while that point keeps its speed, that is a tractrix.
     *
     * @param left speed over the ground of that point, fixed to the body, across the wheel, m/s
     * @param forward the same along it
     */
    void trail(double left, double forward) {
        double speed = Math.hypot(left, forward);
        if (trail > 0 && speed > MIN_SPEED) {
            double way = Math.atan2(left, forward);
            double half = -way / 2;
            double share = Math.exp(-speed * TimeStep.SECONDS / trail);
            point(Math.IEEEremainder(heading + way + 2 * Math.atan2(Math.sin(half) * share, Math.cos(half)), 2 * Math.PI));
        }
    }

    /** Finds its directions in the world: {@code ahead} and {@code left} are the body's. */
    void aim(Vec3 ahead, Vec3 left) {
        mix(rolling, heading, ahead, left);
        mix(driving, heading + rollers, ahead, left);
    }

    private static void mix(Vec3 into, double angle, Vec3 ahead, Vec3 left) {
        into.set(0, 0, 0).add(Math.cos(angle), ahead).add(Math.sin(angle), left);
    }

    /**
     * How fast the point where it touches moves in the direction along which it drives, m/s.
     *
     * @param forward speed of the body's middle, m/s
     * @param turn of the body, rad/s
     * @param centre z of the point that only moves forward, metres
     */
    double along(double forward, double turn, double centre) {
        return (forward - turn * x) * Math.cos(heading + rollers) + turn * (z - centre) * Math.sin(heading + rollers);
    }

    /** Metres over ground along its driving direction for each metre of its rim. */
    double share() {
        return Math.cos(rollers);
    }

    /** Whether it slides across the direction along which it drives, on rollers. */
    boolean isSliding() {
        return slides;
    }

    double heading() {
        return heading;
    }

    double x() {
        return x;
    }

    double z() {
        return z;
    }

    Vec3 rolling() {
        return rolling;
    }

    Vec3 driving() {
        return driving;
    }
}
