// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import java.util.List;
import java.util.function.DoubleSupplier;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Wheel;
import org.SEAR.physics.Body;
import org.SEAR.physics.RobotBodies;

/**
 * Limits of a robot's wheels from its mass, its dimensions and gravity: motor force, grip of skid steering,
 * acceleration. Simulation thread.
 */
final class DriveForces {
    static final double NO_TRACK = 1e-6;
    /** Greatest force of all motors per kilogram of the robot, N/kg (climbs 20 degrees). */
    private static final double MOTOR_FORCE = 4;
    /** The same for a skid-steered robot, whose wheels scrub when it turns. */
    private static final double SKID_FORCE = 9;
    /** Lateral friction of a skid-steered robot's wheels, as a share of the limit set by track and wheelbase. */
    private static final double SKID_GRIP = 0.4;
    /** Lateral damping of all wheels while a skid-steered robot turns, per kilogram, 1/s. */
    private static final double SKID_DAMPING = 25;
    /** Greatest change of the wheels' speed by the motor controller, m/s^2. */
    private static final double RAMP = 4;
    /** The same for an emergency stop, which shorts the motors; the grip of the tyres sets the limit. */
    private static final double BRAKE_RAMP = 20;
    /** Largest acceleration, as a share of the one that lifts a wheel. */
    private static final double TIPPING_SHARE = 0.5;
    /** Smallest limit of the acceleration, for robots that tip over in any case, m/s^2. */
    private static final double MIN_RAMP = 0.2;

    /** Track of the driven wheels, metres. */
    final double track;
    /** Lateral damping of each wheel of a skid-steered robot while it turns, N s/m; 0 for others. */
    final double scrubbing;
    private final boolean stands;
    /** Distance of the centre of mass from the tipping edge, and its height above the ground, metres. */
    private final double room;
    private final double height;
    /** Present gravity, m/s^2. */
    private final DoubleSupplier gravity;

    /** Sets the limits of wheels without a {@link MotorDrive}. */
    DriveForces(Body of, List<RaycastWheel> wheels, DoubleSupplier gravity) {
        this.gravity = gravity;
        Body body = RobotBodies.whole(of);
        List<RaycastWheel> driven = wheels.stream().filter(RaycastWheel::isDriven).collect(Collectors.toList());
        track = mean(driven, 1) + mean(driven, -1);
        double widest = driven.stream().mapToDouble(wheel -> wheel.radius).max().orElse(0);
        double front = driven.stream().filter(wheel -> wheel.getSwivel() == null).mapToDouble(wheel -> wheel.z)
            .max().orElse(0);
        double back = driven.stream().filter(wheel -> wheel.getSwivel() == null).mapToDouble(wheel -> wheel.z)
            .min().orElse(0);
        boolean skid = front - back > widest;
        scrubbing = skid ? SKID_DAMPING * body.mass / driven.size() : 0;
        for (RaycastWheel wheel : driven) {
            wheel.getGrip().setSideShare(skid
                ? Math.min(1, SKID_GRIP * Math.max(track, NO_TRACK) / (front - back)) : 1);
            if (wheel.getMotor() instanceof GearedMotor) {
                ((GearedMotor) wheel.getMotor())
                    .setForce((skid ? SKID_FORCE : MOTOR_FORCE) * body.mass / driven.size());
            }
        }
        stands = wheels.size() >= 3;
        double[] mass = body.getCentre();
        double lowest = wheels.stream().mapToDouble(wheel -> wheel.y - wheel.getRest() - wheel.radius).min().orElse(0);
        List<Wheel> objects = wheels.stream().map(wheel -> wheel.object).collect(Collectors.toList());
        room = stands ? CentreOfMass.room(mass[0], mass[2], objects) : 0;
        height = Math.max(mass[1] - lowest, NO_TRACK);
    }

    /** Greatest change of speed at which a tall robot does not fall over, m/s^2. */
    double getRamp(boolean braking) {
        double most = braking && stands ? BRAKE_RAMP : RAMP;
        return stands ? Math.min(most, Math.max(MIN_RAMP, TIPPING_SHARE * gravity() * room / height)) : most;
    }

    /** Present gravity, m/s^2. */
    double gravity() {
        return gravity.getAsDouble();
    }

    /** Returns the mean distance of the driven wheels on a side from the middle, metres; 0 without any. */
    private static double mean(List<RaycastWheel> driven, int side) {
        return driven.stream().filter(wheel -> wheel.x * side > 0).mapToDouble(wheel -> wheel.x * side)
            .average().orElse(0);
    }
}
