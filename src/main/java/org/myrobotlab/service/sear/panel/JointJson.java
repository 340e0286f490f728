// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.Joint;
import org.SEAR.geometry.Pose;
import org.SEAR.sensors.JointReading;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.JointAdvice;
import org.SEAR.simulator.JointControl;
import org.SEAR.simulator.Simulation;

/** Converts the joints of a world for panels. Simulation thread. */
final class JointJson {
    private static final Map<ActuatorOrder.Kind, String> CALLS = Map.of(
        ActuatorOrder.Kind.JOINT_POSITION, "setJointPosition", ActuatorOrder.Kind.JOINT_SPEED, "setJointSpeed",
        ActuatorOrder.Kind.JOINT_POWER, "setJointPower");

    private JointJson() {
    }

    /** Returns the fields that can change in each step. */
    static List<WorldState.Link> moving(Simulation world) {
        List<WorldState.Link> links = new ArrayList<>();
        for (Joint joint : world.getProject().getAllJoints()) {
            WorldState.Link link = new WorldState.Link();
            Pose[] frames = world.getJoints().frames(joint.getFullName());
            link.pose = frames[0];
            link.end = frames[1];
            link.broken = world.getJoints().isBroken(joint.getFullName());
            if (world.getJoints().isRead(joint.getFullName())) {
                JointReading reading = world.getJoints().reading(joint.getFullName());
                link.words = reading.words("");
                link.numbers = JsonNumbers.numbers(reading.numbers());
            }
            links.add(link);
        }
        return links;
    }

    /** Adds the constant fields. */
    static void addFixed(Simulation world, List<WorldState.Link> links) {
        List<Joint> joints = world.getProject().getAllJoints();
        Map<String, String> reasons = JointAdvice.of(world.getProject());
        for (int i = 0; i < joints.size(); i++) {
            Joint joint = joints.get(i);
            WorldState.Link link = links.get(i);
            link.name = joint.getFullName();
            link.robot = Assembly.robotOf(joint) == null ? "" : Assembly.robotOf(joint).getName();
            link.type = joint.getClass().getSimpleName();
            link.first = Objects.requireNonNullElse(joint.getFirst(), "");
            link.second = joint.getSecond();
            link.names = List.of();
            if (link.numbers != null) {
                JointReading reading = world.getJoints().reading(link.name);
                link.names = reading.names();
                link.unit = reading.unit();
            }
            JointControl control = JointControl.of(joint);
            if (control != null) {
                link.command = CALLS.get(control.kind);
                link.least = control.least;
                link.most = control.most;
            }
            link.still = reasons.get(link.name);
        }
    }
}
