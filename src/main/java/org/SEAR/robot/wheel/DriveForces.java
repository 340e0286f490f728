package org.SEAR.robot.wheel;

import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Wheel;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;

/** What a robot's wheels get by its mass and measures: the force of motors, the grip of those that skid, how fast speeds may change. Immutable. */
final class DriveForces {
    static final double NO_TRACK = 1e-6;
    /** Greatest force of all motors together for each kg of the robot, N/kg (climbs 20 degrees). */
    private static final double MOTOR_FORCE = 4;
    /** The same for a skid-steered robot, whose wheels scrub when it turns. */
    private static final double SKID_FORCE = 9;
    /** Friction across the wheels of a skid-steered robot as a share of what its track and wheelbase would just allow. */
    private static final double SKID_GRIP = 0.4;
    /** While it turns, its wheels resist scrubbing in proportion to speed: force of all together for each kg and m/s, 1/s. */
    private static final double SKID_DAMPING = 25;
    /** Greatest change of the wheels' speed that the motor controller asks for, m/s^2. */
    private static final double RAMP = 4;
    /** The same for an emergency stop, which shorts the motors; the grip of the tyres sets the limit. */
    private static final double BRAKE_RAMP = 20;
    /** The same as a share of what would lift a wheel off the ground. */
    private static final double TIPPING_SHARE = 0.5;
    /** What tips over anyway starts and stops so, m/s^2. */
    private static final double MIN_RAMP = 0.2;

    /** Distance of the left from the right driven wheels, metres. */
    final double track;
    /** Damping with which each wheel of a skid-steered robot resists scrubbing while it turns, N s/m; 0 for others. */
    final double scrubbing;
    /** Greatest change of speed, and that of an emergency stop, m/s^2. */
    final double ramp;
    final double brakeRamp;

    /** Equips the wheels that no {@link MotorDrive} turns. */
    DriveForces(Body body, List<RaycastWheel> wheels) {
        List<RaycastWheel> driven = wheels.stream().filter(RaycastWheel::isDriven).collect(Collectors.toList());
        track = mean(driven, 1) + mean(driven, -1);
        double widest = driven.stream().mapToDouble(wheel -> wheel.radius).max().orElse(0);
        double front = driven.stream().filter(wheel -> wheel.getSwivel() == null).mapToDouble(wheel -> wheel.z).max().orElse(0);
        double back = driven.stream().filter(wheel -> wheel.getSwivel() == null).mapToDouble(wheel -> wheel.z).min().orElse(0);
        boolean skid = front - back > widest;
        scrubbing = skid ? SKID_DAMPING * body.mass / driven.size() : 0;
        for (RaycastWheel wheel : driven) {
            wheel.getGrip().setSideShare(skid ? Math.min(1, SKID_GRIP * Math.max(track, NO_TRACK) / (front - back)) : 1);
            if (wheel.getMotor() instanceof GearedMotor) {
                ((GearedMotor) wheel.getMotor()).setForce((skid ? SKID_FORCE : MOTOR_FORCE) * body.mass / driven.size());
            }
        }
        double safe = safeRamp(body, wheels);
        ramp = Math.min(RAMP, safe);
        brakeRamp = wheels.size() < 3 ? RAMP : Math.min(BRAKE_RAMP, safe);
    }

    /** Mean distance of the driven wheels on a side from the middle, metres; 0 without any. */
    private static double mean(List<RaycastWheel> driven, int side) {
        return driven.stream().filter(wheel -> wheel.x * side > 0).mapToDouble(wheel -> wheel.x * side).average().orElse(0);
    }

    /** How fast speeds may change, m/s^2: a tall robot must not fall over when it starts or stops. */
    private static double safeRamp(Body body, List<RaycastWheel> wheels) {
        if (wheels.size() < 3) {
            return Double.POSITIVE_INFINITY;
        }
        double[] mass = body.getCentre();
        double lowest = wheels.stream().mapToDouble(wheel -> wheel.y - wheel.getRest() - wheel.radius).min().orElse(0);
        List<Wheel> objects = wheels.stream().map(wheel -> wheel.object).collect(Collectors.toList());
        double room = CentreOfMass.room(mass[0], mass[2], objects);
        return Math.max(MIN_RAMP, TIPPING_SHARE * PhysicsWorld.GRAVITY * room / Math.max(mass[1] - lowest, NO_TRACK));
    }
}
