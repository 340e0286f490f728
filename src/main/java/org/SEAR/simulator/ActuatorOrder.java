// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import org.SEAR.physics.joint.JointAxis;
import org.SEAR.robot.Robot;

/**
 * A command to a motor, servo, light or the steering of a robot, run by {@link Simulation#order}. Records store it.
 * Immutable, any thread.
 */
public final class ActuatorOrder {
    /** Actuator and quantity of a command. Records store the ordinal. */
    public enum Kind {
        /** Motor: share of the full voltage, -1 to 1. */
        POWER,
        /** Motor: speed of its wheels, rad/s. */
        SPEED,
        /** Servo: angle, degrees. */
        ANGLE,
        /** Light: brightness, 0 to 1. */
        BRIGHTNESS,
        /** Robot: steering angle of an imaginary wheel in the middle, degrees, + to the left. */
        STEERING,
        /** Motor of a joint: position, degrees or metres. */
        JOINT_POSITION,
        /** Motor of a joint: speed, degrees or metres a second. */
        JOINT_SPEED,
        /** Motor of a joint: power, -1 to 1. */
        JOINT_POWER
    }

    public final Kind kind;
    /** Name of the motor, servo or light, as {@link Simulation#getMotor} takes it, or of the robot. */
    public final String name;
    public final double value;

    public ActuatorOrder(Kind kind, String name, double value) {
        this.kind = kind;
        this.name = name;
        this.value = value;
    }

    /** @throws IllegalArgumentException that lists the valid names or states the legal range */
    void giveTo(Simulation simulation) {
        switch (kind) {
            case POWER:
                simulation.getMotor(name).setPower(value);
                break;
            case SPEED:
                simulation.getMotor(name).setSpeed(value);
                break;
            case ANGLE:
                simulation.getServo(name).setAngle(value);
                break;
            case BRIGHTNESS:
                simulation.getLight(name).setBrightness(value);
                break;
            case JOINT_POSITION:
                simulation.getJoints().drive(name, JointAxis.Drive.POSITION, value);
                break;
            case JOINT_SPEED:
                simulation.getJoints().drive(name, JointAxis.Drive.SPEED, value);
                break;
            case JOINT_POWER:
                simulation.getJoints().drive(name, JointAxis.Drive.POWER, value);
                break;
            default:
                robot(simulation).steer(value);
                break;
        }
    }

    private Robot robot(Simulation simulation) {
        return simulation.getRobots().stream().filter(robot -> robot.getObject().getName().equals(name)).findFirst()
            .orElseThrow(() -> new IllegalArgumentException("no robot is called \"" + name + "\""));
    }
}
