// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.AxisJoint;
import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.ContactForce;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;
import org.SEAR.grammar.Parameter;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ParsedObject;

/**
 * Checks the relations of motors to wheels, servos to mounted parts, and bumpers and force sensors to the parts that
 * press them. One use.
 */
final class VehicleCheck {
    private final Map<String, ParsedObject> parts;
    private final Map<ParsedObject, SEARrobot> owners;
    private final ProblemList problems;
    /** File of the motor or servo that turns a wheel or part, by robot/part. */
    private final Map<String, String> turned = new HashMap<>();

    VehicleCheck(Map<String, ParsedObject> parts, Map<ParsedObject, SEARrobot> owners, ProblemList problems) {
        this.parts = parts;
        this.owners = owners;
        this.problems = problems;
    }

    void check() {
        for (ParsedObject parsed : parts.values()) {
            if (parsed.object instanceof SEARrobot) {
                checkWheels(parsed, (SEARrobot) parsed.object);
            }
        }
        owners.forEach((parsed, robot) -> {
            if (parsed.object instanceof Motor) {
                check(parsed, (Motor) parsed.object, robot);
            } else if (parsed.object instanceof Servo) {
                check(parsed, (Servo) parsed.object, robot);
            } else if (parsed.object instanceof Bumper) {
                checkPressed(parsed, ((Bumper) parsed.object).getPart(), robot);
            } else if (parsed.object instanceof ContactForce) {
                checkPressed(parsed, ((ContactForce) parsed.object).getPart(), robot);
            }
        });
    }

    private void checkWheels(ParsedObject parsed, SEARrobot robot) {
        List<Wheel> wheels = robot.getWheels();
        String servo = null;
        for (int i = 0; i < wheels.size(); i++) {
            Wheel wheel = wheels.get(i);
            int line = parsed.line("wheel#" + i);
            Assembly.crossCheck(wheel, (element, value, legal) ->
                problems.add(parsed.file, line, wheel.getName() + "." + element, Parameter.format(value), legal));
            if (wheel.isSteered() && wheel.getType() != Wheel.IDLER && Wheel.steeringLength(wheels) == 0) {
                problems.add(parsed.file, line, wheel.getName() + ".steering", steeredBy(wheel),
                    "a steered wheel in front of or behind the axle of those that aren't steered");
                return;
            }
            if (wheel.isSteered() && servo != null && !servo.equals(steeredBy(wheel))) {
                problems.add(parsed.file, line, wheel.getName() + ".steering", steeredBy(wheel),
                    "the same as the robot's other steered wheels: " + servo);
            }
            servo = wheel.isSteered() && servo == null ? steeredBy(wheel) : servo;
            String name = wheel.getSteeringServo();
            if (name != null && robot.getComponents().stream()
                .noneMatch(part -> part instanceof Servo && part.getName().equals(name))) {
                problems.add(parsed.file, line, wheel.getName() + ".steeringServo", name,
                    "the name of a servo of robot " + robot.getName());
            }
        }
    }

    private static String steeredBy(Wheel wheel) {
        return wheel.getSteeringServo() == null ? Parameter.format(wheel.getSteering()) : wheel.getSteeringServo();
    }

    private void checkDriven(ParsedObject parsed, String name, SEARrobot robot) {
        SearObject joint = robot.getComponents().stream().filter(one -> one.getName().equals(name)).findFirst()
            .orElse(null);
        String other = turned.putIfAbsent(robot.getName() + "/" + name, parsed.file);
        if (!(joint instanceof AxisJoint)) {
            problems.add(parsed.file, parsed.line("joint"), "joint", name, "the name of a hinge, slider or rope of the "
                + "motor's robot " + robot.getName());
        } else if (((AxisJoint) joint).getStallForce() > 0 || other != null) {
            problems.add(parsed.file, parsed.line("joint"), "joint", name, "a joint that nothing drives yet; "
                + (other == null ? "this one has a motor of its own, by setMotor" : other + " drives it"));
        }
    }

    private void check(ParsedObject parsed, Motor motor, SEARrobot robot) {
        if (motor.getJoint() != null) {
            checkDriven(parsed, motor.getJoint(), robot);
        }
        int index = 0;
        for (String name : motor.getWheelNames()) {
            int line = parsed.line("wheel#" + index++);
            Wheel wheel = robot.getWheels().stream().filter(one -> one.getName().equals(name)).findFirst().orElse(null);
            String other = turned.putIfAbsent(robot.getName() + "/" + name, parsed.file);
            if (wheel == null) {
                problems.add(parsed.file, line, "wheel", name, "a driven wheel (type 1) of the motor's robot "
                    + robot.getName() + ": " + driven(robot));
            } else if (!wheel.isDriven()) {
                problems.add(parsed.file, line, "wheel", name, "a driven wheel (type 1); this one has type "
                    + wheel.getType());
            } else if (other != null) {
                problems.add(parsed.file, line, "wheel", name, "a wheel that nothing turns yet; " + other
                    + " turns it");
            }
        }
    }

    private void check(ParsedObject parsed, Servo servo, SEARrobot robot) {
        int index = 0;
        for (String name : servo.getPartNames()) {
            int line = parsed.line("part#" + index++);
            SearObject part = robot.getComponents().stream().filter(one -> one.getName().equals(name)).findFirst()
                .orElse(null);
            String other = turned.putIfAbsent(robot.getName() + "/" + name, parsed.file);
            if (part == null || !Servo.canTurn(part)) {
                problems.add(parsed.file, line, "part", name, "the name of a component of the servo's robot "
                    + robot.getName() + ": " + Servo.TURNABLE);
            } else if (other != null) {
                problems.add(parsed.file, line, "part", name, "a part that nothing turns yet; " + other + " turns it");
            } else if (new PartCarriers(robot.getComponents()).isCircular(robot.getComponents().indexOf(servo))) {
                problems.add(parsed.file, line, "part", name, "a part that does not turn the servo itself");
            }
        }
    }

    private void checkPressed(ParsedObject parsed, String name, SEARrobot robot) {
        List<String> parts = robot.getComponents().stream().filter(Bumper::canPress).map(SearObject::getName)
            .collect(Collectors.toList());
        if (name != null && !parts.contains(name)) {
            problems.add(parsed.file, parsed.line("part"), "part", name, "the name of a shape of the sensor's robot "
                + robot.getName() + ": " + (parts.isEmpty() ? "it has none" : String.join(", ", parts)));
        }
    }

    private static String driven(SEARrobot robot) {
        List<String> names = robot.getWheels().stream().filter(Wheel::isDriven).map(Wheel::getName)
            .collect(Collectors.toList());
        return names.isEmpty() ? "it has none" : String.join(", ", names);
    }
}
