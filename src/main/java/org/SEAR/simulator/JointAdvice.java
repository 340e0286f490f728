// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.AxisJoint;
import org.SEAR.POJOs.BallJoint;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.Rope;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Slider;
import org.SEAR.geometry.Pose;
import org.SEAR.grammar.Parameter;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.PartCarriers;
import org.SEAR.project.Project;

/** Finds joints that can't move, and the reasons. Any thread. */
public final class JointAdvice {
    private static final String WORLD = "";
    /** Distance and sine of the angle within which two axes are one, metres. */
    private static final double SAME_AXIS = 1e-3;

    private final List<Joint> joints;
    /**
     * For each object another one that fixed joints connect with it, directly or by others, and for each robot/part of
     * a robot what it moves with; the last one has none.
     */
    private final Map<String, String> held = new HashMap<>();
    private final Map<String, String> reasons = new LinkedHashMap<>();

    private JointAdvice(Project project) {
        joints = project.getAllJoints();
        project.getEnvironment().stream().filter(one -> !(one instanceof Shape && ((Shape) one).getMass() > 0))
            .forEach(one -> held.put(one.getName(), WORLD));
        project.getRobots().forEach(this::addParts);
        for (Joint joint : joints) {
            String first = first(joint);
            String second = second(joint);
            if (joint instanceof FixedJoint && joint.getBreakingForce() == null && !first.equals(second)) {
                held.put(first.equals(WORLD) ? second : first, first.equals(WORLD) ? WORLD : second);
            }
        }
    }

    /** Groups the parts of a robot that do not move against each other. */
    private void addParts(SEARrobot robot) {
        PartCarriers carriers = new PartCarriers(robot.getComponents());
        for (int i = 0; i < robot.getComponents().size(); i++) {
            int mover = carriers.mover(i);
            held.put(robot.getName() + "/" + robot.getComponents().get(i).getName(), mover == PartCarriers.NONE
                ? robot.getName() : robot.getName() + "/" + robot.getComponents().get(mover).getName() + "/moved");
        }
    }

    /** Returns the reason for each joint that can't move, by its name: text to follow the joint and "does not move". */
    public static Map<String, String> of(Project project) {
        JointAdvice advice = new JointAdvice(project);
        advice.joints.stream().filter(joint -> !(joint instanceof FixedJoint)).forEach(advice::consider);
        for (Joint joint : advice.joints) {
            String gear = joint instanceof AxisJoint ? ((AxisJoint) joint).getGear() : null;
            SEARrobot robot = Assembly.robotOf(joint);
            boolean still = gear != null && advice.joints.stream().anyMatch(other -> other.getName().equals(gear)
                && Assembly.robotOf(other) == robot && advice.reasons.containsKey(other.getFullName()));
            if (still) {
                advice.reasons.putIfAbsent(joint.getFullName(), "its gear follows " + gear + ", which does not move");
            }
        }
        return Collections.unmodifiableMap(advice.reasons);
    }

    private String first(Joint joint) {
        SEARrobot robot = Assembly.robotOf(joint);
        return group(robot == null ? joint.getFirst() : joint.getFirst() == null ? robot.getName()
            : robot.getName() + "/" + joint.getFirst());
    }

    private String second(Joint joint) {
        SEARrobot robot = Assembly.robotOf(joint);
        return group(robot == null ? joint.getSecond() : robot.getName() + "/" + joint.getSecond());
    }

    private String group(String name) {
        String last = name == null ? WORLD : name;
        while (held.containsKey(last)) {
            last = held.get(last);
        }
        return last;
    }

    /** Returns the name of a joint's first object, or what it is without one. */
    private static String firstName(Joint joint) {
        return joint.getFirst() != null ? joint.getFirst() : Assembly.robotOf(joint) == null ? "the world"
            : "the robot's body";
    }

    private void consider(Joint joint) {
        String why = joint instanceof AxisJoint ? ofAxis((AxisJoint) joint) : null;
        if (first(joint).equals(second(joint))) {
            why = "a fixed joint holds " + firstName(joint) + " and " + joint.getSecond() + " together";
        }
        for (Joint other : joints) {
            if (why == null && isBlocked(joint, other)) {
                why = other.getName() + " joins the same objects along or about another axis";
            }
        }
        if (why != null) {
            reasons.put(joint.getFullName(), why);
        }
    }

    private static String ofAxis(AxisJoint joint) {
        if (joint.getLower() != null && joint.getLower().equals(joint.getUpper()) && !(joint instanceof Rope)) {
            return "its lower and its upper limit are both " + Parameter.format(joint.getLower());
        }
        return joint.getStallForce() > 0 && joint.getFriction() >= joint.getStallForce() ? "its friction, "
            + Parameter.format(joint.getFriction()) + ", is not below the force of its motor at standstill, "
            + Parameter.format(joint.getStallForce()) : null;
    }

    /** Whether another joint of the same objects stops a hinge or a slider. */
    private boolean isBlocked(Joint joint, Joint other) {
        Set<String> ends = Set.of(first(joint), second(joint));
        boolean same = other != joint && !first(other).equals(second(other))
            && Assembly.robotOf(joint) == Assembly.robotOf(other) && ends.equals(Set.of(first(other), second(other)));
        boolean guided = joint instanceof Hinge || joint instanceof Slider;
        if (!same || !guided || other instanceof Rope || other instanceof FixedJoint) {
            return false;
        }
        Pose pose = ObjectPose.of(joint);
        Pose its = ObjectPose.of(other);
        double[] axis = pose.rotate(0, 1, 0);
        boolean parallel = other instanceof BallJoint || distance(its.rotate(0, 1, 0), axis) < SAME_AXIS;
        boolean through = distance(new double[] {its.x - pose.x, its.y - pose.y, its.z - pose.z}, axis) < SAME_AXIS;
        return joint instanceof Hinge ? other instanceof Slider || !parallel || !through
            : !(other instanceof Slider) || !parallel;
    }

    /** Returns the distance of a point from a line through the origin along a unit vector. */
    private static double distance(double[] p, double[] axis) {
        double x = p[1] * axis[2] - p[2] * axis[1];
        double y = p[2] * axis[0] - p[0] * axis[2];
        double z = p[0] * axis[1] - p[1] * axis[0];
        return Math.sqrt(x * x + y * y + z * z);
    }
}
