// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.servo;

import org.SEAR.POJOs.Motor;
import org.SEAR.devices.MotorHardware;
import org.SEAR.grammar.Parameter;

/** A motor with its object. Checks commands. Simulation thread. */
public abstract class RobotMotor implements MotorHardware {
    protected final Motor object;
    private final String robot;

    /** @param robot its name */
    protected RobotMotor(Motor object, String robot) {
        this.object = object;
        this.robot = robot;
    }

    /** Returns the motor's object. */
    public final Motor getObject() {
        return object;
    }

    @Override
    public final String getName() {
        return object.getName();
    }

    /**
     * Checks a command.
     *
     * @param most largest legal magnitude
     * @param unit text that follows the legal range
     * @return the value
     * @throws IllegalArgumentException with motor, robot, value and legal range
     */
    protected final double legal(String what, double value, double most, String unit) {
        if (!(Math.abs(value) <= most)) {
            throw new IllegalArgumentException("motor " + object.getName() + " of robot " + robot + ": " + what + " is "
                + value + ", legal: " + Parameter.format(-most) + " to " + Parameter.format(most) + unit);
        }
        return value;
    }
}
