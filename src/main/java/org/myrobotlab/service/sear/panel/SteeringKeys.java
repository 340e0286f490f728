// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.util.Objects;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;

/** Steering angles for keys of a robot with steered wheels, by a command for the robot or for its steering servo. */
final class SteeringKeys extends JsonForm {
    /** Most useful steering angle, degrees; servos may turn further. */
    private static final double MOST = 30;

    /** Name of the servo as in {@code setServo}; null without one. */
    String servo;
    /** Furthest angles to the left and right of a wheel in the middle, degrees, left positive. */
    double left;
    double right;
    /** Angle nearest to straight ahead, degrees. */
    double straight;

    /** Returns the angles of a robot; null if no wheel is steered. */
    static SteeringKeys of(SEARrobot robot) {
        SteeringKeys steered = new SteeringKeys();
        String name = robot.getWheels().stream().map(Wheel::getSteeringServo).filter(Objects::nonNull).findFirst()
            .orElse(null);
        Servo servo = (Servo) robot.getComponents().stream()
            .filter(part -> part instanceof Servo && part.getName().equals(name)).findFirst().orElse(null);
        if (servo != null) {
            steered.servo = robot.getName() + "/" + name;
            steered.left = Math.max(servo.getMinAngle(), Math.min(servo.getMaxAngle(), MOST));
            steered.right = Math.min(servo.getMaxAngle(), Math.max(servo.getMinAngle(), -MOST));
            steered.straight = Math.max(servo.getMinAngle(), Math.min(servo.getMaxAngle(), 0));
            return steered;
        }
        steered.left = robot.getWheels().stream().filter(wheel -> wheel.getSteering() != null)
            .mapToDouble(Wheel::getSteering).min().orElse(0);
        steered.right = -steered.left;
        return steered.left == 0 ? null : steered;
    }
}
