// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.SEAR.POJOs.DriveErrors;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.TimeStep;
import org.SEAR.grammar.Parameter;
import org.SEAR.robot.servo.DeadTime;
import org.SEAR.robot.servo.ServoDrive;

/**
 * Steered wheels of one robot by Ackermann geometry. All axles point to the turning centre on the line of the unsteered
 * axle; with all wheels steered, on the line midway between them. Simulation thread.
 */
final class Steering {
    /** Steering speed without a servo, rad/s. */
    private static final double SPEED = Math.toRadians(200);

    private final List<RaycastWheel> steered;
    private final ServoDrive servo;
    private final String robot;
    private final double most;
    private final double centre;
    private final double length;
    /** Backlash, radians, dead time, and understeer, rad s^2/m. */
    private final double play;
    private final DeadTime delay;
    private final double understeer;
    private double wanted;
    /** Command that takes effect, and angle of the steering, radians. */
    private double due;
    private double angle;
    /** Angle of the wheels, which follow the steering with play; and their curvature at the present speed. */
    private double followed;
    private double curvature;

    private Steering(List<RaycastWheel> wheels, List<RaycastWheel> steered, ServoDrive servo, String robot,
        DriveErrors errors) {
        this.steered = steered;
        this.servo = servo;
        this.robot = robot;
        most = steered.stream().mapToDouble(wheel -> wheel.object.getSteering() == null ? Double.POSITIVE_INFINITY
            : wheel.object.getSteering())
            .min().orElse(0);
        List<Wheel> objects = wheels.stream().map(wheel -> wheel.object).collect(Collectors.toList());
        centre = Wheel.turningLine(objects);
        length = Wheel.steeringLength(objects);
        play = Math.toRadians(errors.getSteeringPlay());
        delay = new DeadTime(errors.getSteeringDelay());
        understeer = Math.toRadians(errors.getUndersteer());
        point();
    }

    /** Returns the steering of a robot; null if it has no steered wheels. */
    static Steering of(List<RaycastWheel> wheels, Function<String, ServoDrive> servos, String robot,
        DriveErrors errors) {
        List<RaycastWheel> steered = wheels.stream().filter(wheel -> wheel.object.isSteered())
            .collect(Collectors.toList());
        return steered.isEmpty() ? null
            : new Steering(wheels, steered, servos.apply(steered.get(0).object.getSteeringServo()), robot,
            errors);
    }

    /**
     * Commands the steering angle of a wheel in the middle between left and right.
     * @param degrees + to the left
     * @throws IllegalArgumentException with the robot, the value and the legal range
     */
    void steer(double degrees) {
        if (servo != null) {
            throw new IllegalArgumentException("robot " + robot + " is steered by its servo " + servo.getName()
                + ": turn that servo instead");
        }
        if (!(Math.abs(degrees) <= most)) {
            throw new IllegalArgumentException("robot " + robot + ": steering is " + degrees + ", legal: "
                + Parameter.format(-most) + " to "
                + Parameter.format(most) + " deg");
        }
        wanted = Math.toRadians(degrees);
    }

    /** Whether no servo steers. */
    boolean isFree() {
        return servo == null;
    }

    /** @param curvature 1/m, + to the left; limited by the greatest angle */
    void follow(double curvature) {
        double degrees = Math.toDegrees(Math.atan(curvature * length));
        steer(Math.max(-most, Math.min(most, degrees)));
    }

    /** Returns the radius of the smallest circle of its middle, metres. */
    double tightest() {
        return length / Math.tan(Math.toRadians(most));
    }

    /** Greatest angle, degrees. */
    double getMost() {
        return most;
    }

    /** Name of the steering servo; null for none. */
    String getServo() {
        return servo == null ? null : servo.getName();
    }

    /** Steering angle of a wheel in the middle, degrees, + to the left. */
    double getDegrees() {
        return Math.toDegrees(angle);
    }

    /** Whether it has not reached its angle. */
    boolean isMoving() {
        return angle != (servo == null ? due : Math.toRadians(servo.getHornAngle())) || due != wanted && servo == null
            || delay.isPending();
    }

    /**
     * Turns the wheels for one step.
     * @param speed of the robot's middle, m/s
     */
    void step(double speed) {
        due = delay.pass(wanted);
        if (servo != null) {
            angle = Math.toRadians(servo.getHornAngle());
        } else {
            double step = SPEED * TimeStep.SECONDS;
            angle = Math.abs(due - angle) <= step ? due : angle + Math.copySign(step, due - angle);
        }
        followed = Math.max(angle - play / 2, Math.min(angle + play / 2, followed));
        double now = Math.tan(followed) / (length + understeer * speed * speed);
        if (now != curvature) {
            curvature = now;
            point();
        }
    }

    private void point() {
        for (RaycastWheel wheel : steered) {
            double across = 1 - curvature() * wheel.x;
            double along = curvature() * (wheel.z - centre);
            wheel.getSwivel().steer(across < 0 ? Math.atan2(-along, -across) : Math.atan2(along, across));
        }
    }

    /** Returns the curvature of its middle's path, 1/m, + to the left. */
    double curvature() {
        return curvature;
    }

    /** z of its turning line in the body frame, metres. */
    double getCentre() {
        return centre;
    }
}
