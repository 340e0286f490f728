package org.myrobotlab.service.sear.panel;

import java.util.Objects;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;

/** How a robot with steered wheels is steered by who holds a key: by an order for the robot, or for the servo that steers them. */
final class SteeringKeys extends JsonForm {
    /** A servo may turn farther than wheels are any good at, degrees. */
    private static final double MOST = 30;

    /** The servo's name, as {@code setServo} takes it; null if none steers. */
    String servo;
    /** Of a wheel in the middle, degrees, + to the left: as far to the left, and to the right, as it goes. */
    double left;
    double right;
    /** And as near to straight ahead as it goes. */
    double straight;

    /** That of a robot; null if no wheel is steered. */
    static SteeringKeys of(SEARrobot robot) {
        SteeringKeys steered = new SteeringKeys();
        String name = robot.getWheels().stream().map(Wheel::getSteeringServo).filter(Objects::nonNull).findFirst().orElse(null);
        Servo servo = (Servo) robot.getComponents().stream().filter(part -> part instanceof Servo && part.getName().equals(name)).findFirst()
            .orElse(null);
        if (servo != null) {
            steered.servo = robot.getName() + "/" + name;
            steered.left = Math.max(servo.getMinAngle(), Math.min(servo.getMaxAngle(), MOST));
            steered.right = Math.min(servo.getMaxAngle(), Math.max(servo.getMinAngle(), -MOST));
            steered.straight = Math.max(servo.getMinAngle(), Math.min(servo.getMaxAngle(), 0));
            return steered;
        }
        steered.left = robot.getWheels().stream().filter(wheel -> wheel.getSteering() != null).mapToDouble(Wheel::getSteering).min().orElse(0);
        steered.right = -steered.left;
        return steered.left == 0 ? null : steered;
    }
}
