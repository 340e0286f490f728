// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.List;
import java.util.TreeMap;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.devices.LightHardware;
import org.SEAR.devices.MotorHardware;
import org.SEAR.devices.ServoHardware;
import org.SEAR.project.PartNames;
import org.SEAR.robot.RobotModel;

/** Finds motors, servos and lights of all robots by name. The objects found belong to the simulation thread. */
final class Actuators {
    private final PartNames<MotorHardware> motors = new PartNames<>();
    private final PartNames<ServoHardware> servos = new PartNames<>();
    private final PartNames<LightHardware> leds = new PartNames<>();
    /** Kind of each actuator by full name, sorted. */
    private final TreeMap<String, String> names = new TreeMap<>();

    Actuators(List<RobotModel> robots) {
        for (RobotModel robot : robots) {
            String name = robot.getObject().getName();
            for (SearObject part : robot.getObject().getComponents()) {
                if (part instanceof Motor) {
                    motors.add(name, part.getName(), robot.getMotor(part.getName()));
                    names.put(part.getFullName(), "motor");
                } else if (part instanceof Servo) {
                    servos.add(name, part.getName(), robot.getServo(part.getName()));
                    names.put(part.getFullName(), "servo");
                } else if (part instanceof Led) {
                    leds.add(name, part.getName(), robot.getLight(part.getName()));
                    names.put(part.getFullName(), "led");
                }
            }
        }
    }

    MotorHardware motor(String name) {
        return found(motors.find(name), "motor", name);
    }

    ServoHardware servo(String name) {
        return found(servos.find(name), "servo", name);
    }

    LightHardware led(String name) {
        return found(leds.find(name), "led", name);
    }

    private <T> T found(T thing, String kind, String name) {
        if (thing == null) {
            StringBuilder there = new StringBuilder();
            names.forEach((one, of) -> there.append(of.equals(kind) ? " " + one : ""));
            throw new IllegalArgumentException("no " + kind + " is called \"" + name + "\", legal:"
                + (there.length() == 0 ? " none, no robot of the project has one" : there));
        }
        return thing;
    }
}
