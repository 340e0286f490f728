// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.SEAR.POJOs.AxisJoint;
import org.SEAR.POJOs.BallJoint;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.Rope;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Slider;
import org.SEAR.geometry.Pose;
import org.SEAR.grammar.Parameter;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;

/** Finds joints that can't move, and the reasons. Any thread. */
public final class JointAdvice {
    private static final String WORLD = "";
    /** Distance and sine of the angle within which two axes are one, metres. */
    private static final double SAME_AXIS = 1e-3;

    private final Project project;
    /** For each object another one that fixed joints connect with it, directly or by others; the last one has none. */
    private final Map<String, String> held = new HashMap<>();
    private final Map<String, String> reasons = new LinkedHashMap<>();

    private JointAdvice(Project project) {
        this.project = project;
        project.getEnvironment().stream().filter(one -> !(one instanceof Shape && ((Shape) one).getMass() > 0))
            .forEach(one -> held.put(one.getName(), WORLD));
        for (Joint joint : project.getJoints()) {
            String first = group(joint.getFirst());
            String second = group(joint.getSecond());
            if (joint instanceof FixedJoint && joint.getBreakingForce() == null && !first.equals(second)) {
                held.put(first.equals(WORLD) ? second : first, first.equals(WORLD) ? WORLD : second);
            }
        }
    }

    /** Returns the reason for each joint that can't move, by its name: text to follow the joint and "does not move". */
    public static Map<String, String> of(Project project) {
        JointAdvice advice = new JointAdvice(project);
        project.getJoints().stream().filter(joint -> !(joint instanceof FixedJoint)).forEach(advice::consider);
        for (Joint joint : project.getJoints()) {
            String gear = joint instanceof AxisJoint ? ((AxisJoint) joint).getGear() : null;
            if (advice.reasons.containsKey(gear)) {
                advice.reasons.putIfAbsent(joint.getName(), "its gear follows " + gear + ", which does not move");
            }
        }
        return Collections.unmodifiableMap(advice.reasons);
    }

    private String group(String name) {
        String last = name == null ? WORLD : name;
        while (held.containsKey(last)) {
            last = held.get(last);
        }
        return last;
    }

    private static String called(String name) {
        return name == null ? "the world" : name;
    }

    private void consider(Joint joint) {
        String why = joint instanceof AxisJoint ? ofAxis((AxisJoint) joint) : null;
        if (group(joint.getFirst()).equals(group(joint.getSecond()))) {
            why = "a fixed joint holds " + called(joint.getFirst()) + " and " + joint.getSecond() + " together";
        }
        for (Joint other : project.getJoints()) {
            if (why == null && isBlocked(joint, other)) {
                why = other.getName() + " joins the same objects along or about another axis";
            }
        }
        if (why != null) {
            reasons.put(joint.getName(), why);
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
        Set<String> ends = Set.of(group(joint.getFirst()), group(joint.getSecond()));
        boolean same = other != joint && !group(other.getFirst()).equals(group(other.getSecond()))
            && ends.equals(Set.of(group(other.getFirst()), group(other.getSecond())));
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
