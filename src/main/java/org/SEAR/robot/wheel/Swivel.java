// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.TimeStep;
import org.SEAR.geometry.Vec3;

/**
 * Direction of a wheel that does not simply point ahead: steered, a caster, with rollers, or with a rotated axle.
 * Angles are radians about the body's up axis, + to the left. Simulation thread.
 */
final class Swivel {
    /** Speed below which a caster keeps its direction, m/s. */
    private static final double MIN_SPEED = 1e-6;

    private final double mountX;
    private final double mountZ;
    private final double home;
    private final double rollers;
    private final double trail;
    private final boolean slides;
    private double heading;
    /** Wheel centre in the body frame, metres. */
    private double x;
    private double z;
    /** Direction in which it rolls, and direction in which it drives and brakes, in the world. */
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

    /** Returns the swivel of a wheel; null for one that points ahead. */
    static Swivel of(Wheel wheel) {
        boolean plain = !wheel.isSteered() && wheel.getTrail() == 0 && wheel.getRollers() == null && wheel.getRy() == 0;
        return plain ? null : new Swivel(wheel);
    }

    private void point(double newHeading) {
        heading = newHeading;
        x = mountX - trail * Math.sin(heading);
        z = mountZ - trail * Math.cos(heading);
    }

    /** @param angle from the unsteered direction */
    void steer(double angle) {
        point(home + angle);
    }

    /**
     * Turns a caster. It has no moment of its own and follows as on rails: the lateral motion of its contact point
     * turns it, and it rolls without slipping. With constant velocity of that point within a step, its path is a
     * tractrix.
     * @param left lateral speed over the ground of the contact point, fixed to the body, m/s
     * @param forward speed of the point along the wheel, m/s
     */
    void trail(double left, double forward) {
        double speed = Math.hypot(left, forward);
        if (trail > 0 && speed > MIN_SPEED) {
            double way = Math.atan2(left, forward);
            double half = -way / 2;
            double share = Math.exp(-speed * TimeStep.SECONDS / trail);
            point(Math.IEEEremainder(heading + way + 2 * Math.atan2(Math.sin(half) * share, Math.cos(half)),
                2 * Math.PI));
        }
    }

    /** Updates its directions in the world: {@code ahead} and {@code left} are the body's. */
    void aim(Vec3 ahead, Vec3 left) {
        mix(rolling, heading, ahead, left);
        mix(driving, heading + rollers, ahead, left);
    }

    private static void mix(Vec3 into, double angle, Vec3 ahead, Vec3 left) {
        into.set(0, 0, 0).add(Math.cos(angle), ahead).add(Math.sin(angle), left);
    }

    /**
     * Returns the speed of its contact point along the driving direction, m/s.
     * @param forward speed of the body's middle, m/s
     * @param turn of the body, rad/s
     * @param centre z of the point that only moves forward, metres
     */
    double along(double forward, double turn, double centre) {
        return (forward - turn * x) * Math.cos(heading + rollers) + turn * (z - centre) * Math.sin(heading + rollers);
    }

    /** Distance over ground along its driving direction per metre of its rim. */
    double share() {
        return Math.cos(rollers);
    }

    /** Cosine of its unsteered driving direction to the body's forward axis. */
    double ahead() {
        return Math.cos(home + rollers);
    }

    /** Whether it slides across its driving direction, on rollers. */
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
