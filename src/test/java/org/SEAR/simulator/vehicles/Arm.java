// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;

/** Servos with boxes on them. */
final class Arm {
    private Arm() {
    }

    /**
     * Adds a servo with the parts that it turns.
     * @param speed degrees per second
     * @param torque N m
     */
    static Servo on(SEARrobot robot, Servo servo, double speed, double torque, Box... parts) {
        servo.setSpeed(speed);
        servo.setStallTorque(torque);
        robot.addComponent(servo);
        for (Box part : parts) {
            servo.mount(part);
            robot.addComponent(part);
        }
        return servo;
    }

    /** @param at x, y and z, metres */
    static Box box(String name, double width, double length, double height, double mass, double... at) {
        Box box = new Box(name, width, length, height, mass);
        box.move(at[0], at[1], at[2]);
        return box;
    }
}
