// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.PartNames;
import org.SEAR.project.Project;
import org.SEAR.robot.RobotModel;

/** Finds poses of robots, parts and environment objects by name. Simulation thread. */
final class PoseLookup {
    private final Project project;
    private final Map<String, Supplier<Pose>> whole = new HashMap<>();
    private final PartNames<Supplier<Pose>> parts = new PartNames<>();

    PoseLookup(Project project, World world) {
        this.project = project;
        List<SearObject> environment = project.getEnvironment();
        for (int i = 0; i < environment.size(); i++) {
            int index = i;
            whole.put(environment.get(i).getName(), () -> world.getPoses().get(index));
        }
        for (RobotModel robot : world.getRobots()) {
            String name = robot.getObject().getName();
            whole.put(name, robot::getPose);
            List<SearObject> components = robot.getObject().getComponents();
            for (int i = 0; i < components.size(); i++) {
                SearObject part = components.get(i);
                int index = i;
                Pose home = ObjectPose.of(part);
                parts.add(name, part.getName(), part instanceof Dynamics ? robot::getPose
                    : () -> robot.getPose().times(robot.getPartPoses().isEmpty() ? home : robot.getPartPoses()
                        .get(index)));
            }
            List<Wheel> wheels = robot.getObject().getWheels();
            for (int i = 0; i < wheels.size(); i++) {
                int index = i;
                parts.add(name, wheels.get(i).getName(), () -> robot.getPose()
                    .times(robot.getTrain().getWheels().get(index).place()));
            }
        }
    }

    Pose find(String name) {
        Supplier<Pose> found = whole.containsKey(name) ? whole.get(name) : parts.find(name);
        if (found == null) {
            throw new IllegalArgumentException("nothing is named \"" + name + "\"; there are " + names());
        }
        return found.get();
    }

    private String names() {
        List<String> names = new ArrayList<>();
        for (SEARrobot robot : project.getRobots()) {
            names.add(robot.getName());
            robot.getComponents().forEach(part -> names.add(part.getFullName()));
            robot.getWheels().forEach(wheel -> names.add(wheel.getFullName()));
        }
        project.getEnvironment().forEach(object -> names.add(object.getName()));
        return String.join(" ", names);
    }
}
