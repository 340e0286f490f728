// SPDX-License-Identifier: Apache-2.0
package org.SEAR.learning;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.AxisJoint;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;
import org.SEAR.grammar.Parameter;
import org.SEAR.robot.DriveOrder;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.JointControl;
import org.SEAR.simulator.Simulation;

/**
 * Controls that an action of a learner sets: motors and servos of its robot and joints by their names, wheel speeds and
 * steering.
 * Simulation thread.
 */
final class Controls {
    private static final String LEFT = "left";
    private static final String RIGHT = "right";
    private static final String SPEED = "speed";
    private static final String STEERING = "steering";
    private static final Set<String> WHEELS = Set.of(LEFT, RIGHT, SPEED);

    /** Endings of a joint's name that choose what an action sets. */
    private static final Map<String, ActuatorOrder.Kind> OF_JOINTS = Map.of(".position",
        ActuatorOrder.Kind.JOINT_POSITION, ".speed", ActuatorOrder.Kind.JOINT_SPEED, ".power",
        ActuatorOrder.Kind.JOINT_POWER);

    private final Simulation simulation;
    private final Robot robot;
    private final int number;
    private final double fastest;
    private final List<Control> controls = new ArrayList<>();

    /** One number of an action and its legal range. */
    private static final class Control {
        private final String name;
        /** The actuator's command; null for the speed of wheels. */
        private final ActuatorOrder.Kind kind;
        private final String actuator;
        private final double least;
        private final double most;

        private Control(String name, ActuatorOrder.Kind kind, String actuator, double least, double most) {
            this.name = name;
            this.kind = kind;
            this.actuator = actuator;
            this.least = least;
            this.most = most;
        }
    }

    /**
     * @param number index of the robot
     * @param fastest highest wheel speed over ground, m/s
     * @throws IllegalArgumentException with the legal names
     */
    Controls(Simulation simulation, Robot robot, int number, double fastest, List<String> names) {
        this.simulation = simulation;
        this.robot = robot;
        this.number = number;
        this.fastest = fastest;
        names.forEach(name -> controls.add(control(name)));
        List<String> ofWheels = controls.stream().filter(one -> one.kind == null).map(one -> one.name)
            .collect(Collectors.toList());
        boolean paired = ofWheels.contains(LEFT) == ofWheels.contains(RIGHT);
        if (!paired || ofWheels.size() > 1 && ofWheels.contains(SPEED)) {
            throw new IllegalArgumentException("robot " + robotName() + ": actions set " + String.join(", ", ofWheels)
                + ", legal: left and right, or speed alone");
        }
    }

    private String robotName() {
        return robot.getObject().getName();
    }

    private Control control(String name) {
        for (SearObject part : robot.getObject().getComponents()) {
            if (part.getName().equals(name) && part instanceof Motor) {
                return new Control(name, ActuatorOrder.Kind.POWER, part.getFullName(), -1, 1);
            } else if (part.getName().equals(name) && part instanceof Servo) {
                Servo servo = (Servo) part;
                return new Control(name, ActuatorOrder.Kind.ANGLE, part.getFullName(), servo.getMinAngle(),
                    servo.getMaxAngle());
            }
        }
        if (WHEELS.contains(name)) {
            DriveOrder.checkWheels(robot, 0, 0);
            return new Control(name, null, "", -fastest, fastest);
        }
        if (name.equals(STEERING)) {
            robot.steer(0);    // an error says why it can't steer
            double most = robot.getObject().getWheels().stream().filter(Wheel::isSteered)
                .mapToDouble(Wheel::getSteering).min().orElseThrow();
            return new Control(name, ActuatorOrder.Kind.STEERING, robotName(), -most, most);
        }
        Control ofJoint = ofJoint(name);
        if (ofJoint != null) {
            return ofJoint;
        }
        String parts = robot.getObject().getComponents().stream()
            .filter(part -> part instanceof Motor || part instanceof Servo)
            .map(part -> part.getName() + ", ").collect(Collectors.joining());
        String joints = joints().filter(joint -> JointControl.of(joint) != null)
            .map(joint -> joint.getName() + ", ").collect(Collectors.joining());
        throw new IllegalArgumentException("robot " + robotName() + " has no motor or servo \"" + name
            + "\" for actions, legal: " + parts + joints + "left and right, speed, steering");
    }

    /** Returns the joints of the robot itself, then those of the environment. */
    private Stream<Joint> joints() {
        return Stream.concat(robot.getObject().getComponents().stream().filter(Joint.class::isInstance)
            .map(Joint.class::cast), simulation.getProject().getJoints().stream());
    }

    /** Returns the control of a joint, or of one quantity of it; null if there is no such joint with a motor. */
    private Control ofJoint(String name) {
        for (Joint joint : (Iterable<Joint>) joints()::iterator) {
            JointControl control = JointControl.of(joint);
            String own = joint.getName();
            String ending = name.startsWith(own) ? name.substring(own.length()) : "";
            if (control != null && OF_JOINTS.containsKey(ending)) {
                control = JointControl.of((AxisJoint) joint, OF_JOINTS.get(ending));
            } else if (control == null || !name.equals(own)) {
                continue;
            }
            return new Control(name, control.kind, joint.getFullName(), control.least, control.most);
        }
        return null;
    }

    /**
     * Checks the numbers of an action.
     *
     * @throws IllegalArgumentException with the name, the value and the legal range
     */
    void check(double... values) {
        if (values.length != controls.size()) {
            throw new IllegalArgumentException("robot " + robotName() + ": an action has " + values.length
                + " numbers, legal: " + controls.size());
        }
        for (int i = 0; i < values.length; i++) {
            Control control = controls.get(i);
            if (!(values[i] >= control.least && values[i] <= control.most)) {
                throw new IllegalArgumentException("robot " + robotName() + ": " + control.name + " is "
                    + Parameter.format(values[i]) + ", legal: "
                    + Parameter.format(control.least) + " to " + Parameter.format(control.most));
            }
        }
        DriveOrder.checkWheels(robot, wheel(values, LEFT), wheel(values, RIGHT));
    }

    /** Sets the controls from the next step on: first wheels, then steering, motors and servos. */
    void give(double... values) {
        if (controls.stream().anyMatch(control -> control.kind == null)) {
            simulation.post(DriveCommand.wheels(number, wheel(values, LEFT), wheel(values, RIGHT)));
        }
        for (int i = 0; i < values.length; i++) {
            Control control = controls.get(i);
            if (control.kind != null) {
                ActuatorOrder order = new ActuatorOrder(control.kind, control.actuator, values[i]);
                simulation.post(world -> world.order(order));
            }
        }
    }

    /** Returns the speed of a side, m/s; 0 if no control sets it. */
    private double wheel(double[] values, String side) {
        for (int i = 0; i < values.length; i++) {
            Control control = controls.get(i);
            if (control.kind == null && (control.name.equals(side) || control.name.equals(SPEED))) {
                return values[i];
            }
        }
        return 0;
    }
}
