// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.AxisJoint;
import org.SEAR.POJOs.ForceTorque;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Shape;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ParsedObject;

/** Checks the objects and parts that joints connect, their gears, and the sensors at joints. One use. */
final class JointCheck {
    private static final int MAX_JOINTS = 1000;

    private final Map<String, ParsedObject> environment;
    private final Map<String, ParsedObject> parts;
    private final Map<ParsedObject, SEARrobot> owners;
    private final ProblemList problems;

    JointCheck(Map<String, ParsedObject> environment, Map<String, ParsedObject> parts,
        Map<ParsedObject, SEARrobot> owners, ProblemList problems) {
        this.environment = environment;
        this.parts = parts;
        this.owners = owners;
        this.problems = problems;
    }

    void check() {
        long count = environment.values().stream().filter(parsed -> parsed.object instanceof Joint).count()
            + owners.keySet().stream().filter(parsed -> parsed.object instanceof Joint).count();
        if (count > MAX_JOINTS) {
            problems.add(ProjectFolder.ENVIRONMENT, 0, "", "it has " + count + " joints", "at most " + MAX_JOINTS);
        }
        for (ParsedObject parsed : environment.values()) {
            if (parsed.object instanceof Joint) {
                checkInWorld(parsed, (Joint) parsed.object);
                checkGear(parsed, environment);
            }
        }
        owners.forEach((parsed, robot) -> {
            if (parsed.object instanceof Joint) {
                checkInRobot(parsed, (Joint) parsed.object, robot);
                checkGear(parsed, partsOf(robot));
            } else if (parsed.object instanceof ForceTorque) {
                checkSensor(parsed, ((ForceTorque) parsed.object).getJoint(), partsOf(robot));
            }
        });
    }

    private Map<String, ParsedObject> partsOf(SEARrobot robot) {
        return owners.keySet().stream().filter(parsed -> !parsed.isBroken() && owners.get(parsed) == robot)
            .collect(Collectors.toMap(parsed -> ((SearObject) parsed.object).getName(), parsed -> parsed,
                (one, other) -> one));
    }

    /** Checks that a joint connects existing objects, of which one can move. */
    private void checkInWorld(ParsedObject parsed, Joint joint) {
        boolean movable = canMove(parsed, "first", joint.getFirst()) | canMove(parsed, "second", joint.getSecond());
        if (!movable && !problems.isFull()) {
            problems.add(parsed.file, parsed.line("second"), "second", joint.getSecond(),
                "an object that can move: this joint connects only"
                + " fixed ones, and setMass(kg) makes one movable");
        }
        if (!joint.getPartNames().isEmpty()) {
            problems.add(parsed.file, parsed.line("part#0"), "part", joint.getPartNames().get(0),
                "none: only a joint within a robot has parts that move along");
        }
    }

    /** Whether an end of a joint can move, or is invalid, which becomes a problem. */
    private boolean canMove(ParsedObject joint, String element, String name) {
        if (name == null) {
            return false;
        }
        ParsedObject object = environment.get(name);
        if (object != null && (object.isBroken() || object.object instanceof Shape)) {
            return object.isBroken() || ((Shape) object.object).getMass() > 0;
        }
        ParsedObject robot = parts.get(name);
        if (robot == null || !robot.isBroken() && !(robot.object instanceof SEARrobot)) {
            problems.add(joint.file, joint.line(element), element, name, "the name of an object of the environment "
                + "or of a robot" + (robot != null && owners.containsKey(robot) ? "; robot.addComponent(joint) makes it"
                    + " a joint within a robot" : ""));
        }
        return true;
    }

    /** Checks that a joint connects shapes of its robot that can move against each other. */
    private void checkInRobot(ParsedObject parsed, Joint joint, SEARrobot robot) {
        List<SearObject> components = robot.getComponents();
        boolean whole = isShape(parsed, "first", joint.getFirst(), robot)
            & isShape(parsed, "second", joint.getSecond(), robot);
        PartCarriers carriers = new PartCarriers(components);
        int own = components.indexOf(joint);
        if (joint.isCollide()) {
            problems.add(parsed.file, parsed.line("collide"), "collide", "true",
                "false within a robot, whose parts pass through each other");
        }
        for (int i = 0; i < joint.getPartNames().size(); i++) {
            String name = joint.getPartNames().get(i);
            int part = indexOf(components, name);
            boolean ours = part >= 0 && carriers.mover(part) == carriers.mover(joint.getSecond())
                && !name.equals(joint.getSecond());
            if (part < 0 || !Servo.canTurn(components.get(part))) {
                problems.add(parsed.file, parsed.line("part#" + i), "part", name, "the name of a component of the "
                    + "joint's robot " + robot.getName() + ": " + Servo.TURNABLE);
            } else if (whole && !ours) {
                problems.add(parsed.file, parsed.line("part#" + i), "part", name,
                    "a part that no other servo or joint moves");
            }
        }
        if (whole && carriers.mover(joint.getFirst()) == carriers.mover(joint.getSecond())) {
            problems.add(parsed.file, parsed.line("second"), "second", joint.getSecond(), "a shape that can move "
                + "against the first one: " + joint.getFirst() + " moves with it");
        } else if (whole && carriers.isCircular(own)) {
            problems.add(parsed.file, parsed.line("first"), "first", joint.getFirst(), "a shape that the second one, "
                + joint.getSecond() + ", does not move");
        }
    }

    private static int indexOf(List<SearObject> components, String name) {
        return components.stream().map(SearObject::getName).collect(Collectors.toList()).indexOf(name);
    }

    /** Whether an end of a joint within a robot is valid; otherwise it becomes a problem. */
    private boolean isShape(ParsedObject parsed, String element, String name, SEARrobot robot) {
        boolean valid = element.equals("first") && name == null || robot.getComponents().stream()
            .anyMatch(part -> part instanceof Shape && part.getName().equals(name));
        if (!valid) {
            String shapes = robot.getComponents().stream().filter(part -> part instanceof Shape)
                .map(SearObject::getName).collect(Collectors.joining(", "));
            problems.add(parsed.file, parsed.line(element), element, name, "the name of a shape of the joint's robot "
                + robot.getName() + ": " + (shapes.isEmpty() ? "it has none" : shapes));
        }
        return valid;
    }

    /** Checks that a gear leads to an existing joint, and by its gears not back. */
    private void checkGear(ParsedObject parsed, Map<String, ParsedObject> all) {
        List<String> names = new ArrayList<>();
        ParsedObject last = parsed;
        while (last != null && last.object instanceof AxisJoint && ((AxisJoint) last.object).getGear() != null
            && !names.contains(((AxisJoint) last.object).getGear())) {
            names.add(((AxisJoint) last.object).getGear());
            last = all.get(((AxisJoint) last.object).getGear());
        }
        String name = names.isEmpty() ? null : names.get(0);
        ParsedObject other = name == null ? null : all.get(name);
        if (name != null && (other == null || !other.isBroken() && !(other.object instanceof AxisJoint))) {
            problems.add(parsed.file, parsed.line("gear"), "gear", name, "the name of a Hinge, Slider or Rope"
                + (all == environment ? "" : " of the same robot"));
        } else if (names.contains(((Joint) parsed.object).getName())) {
            problems.add(parsed.file, parsed.line("gear"), "gear", name, "a joint that does not follow this one: "
                + String.join(" follows ", names));
        }
    }

    /** Checks that a sensor at a joint names one of its robot or of the environment. */
    private void checkSensor(ParsedObject parsed, String name, Map<String, ParsedObject> own) {
        ParsedObject joint = name == null ? null : own.getOrDefault(name, environment.get(name));
        if (name != null && (joint == null || !joint.isBroken() && !(joint.object instanceof Joint))) {
            problems.add(parsed.file, parsed.line("joint"), "joint", name, "the name of a joint");
        }
    }
}
