package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;
import org.SEAR.robot.RaycastWheel;
import org.SEAR.robot.RobotModel;

/** Finds where things are by their names. Simulation thread. */
final class Places {
    private Places() {
    }

    static Pose find(Project project, World world, String name) {
        List<SearObject> environment = project.getEnvironment();
        for (int i = 0; i < environment.size(); i++) {
            if (environment.get(i).getName().equals(name)) {
                return world.getPoses().get(i);
            }
        }
        for (RobotModel robot : world.getRobots()) {
            Pose pose = robot.getPose();
            if (robot.getObject().getName().equals(name) || robot.getDynamics().getName().equals(name)) {
                return pose;
            }
            for (SearObject part : robot.getObject().getComponents()) {
                if (part.getName().equals(name)) {
                    return pose.times(ObjectPose.of(part));
                }
            }
            for (RaycastWheel wheel : robot.getTrain().getWheels()) {
                if (wheel.object.getName().equals(name)) {
                    return pose.times(wheel.place());
                }
            }
        }
        throw new IllegalArgumentException("nothing is named \"" + name + "\"; there are " + names(project));
    }

    private static String names(Project project) {
        List<String> names = new ArrayList<>();
        for (SEARrobot robot : project.getRobots()) {
            names.add(robot.getName());
            robot.getComponents().forEach(part -> names.add(part.getName()));
            robot.getWheels().forEach(wheel -> names.add(wheel.getName()));
        }
        project.getEnvironment().forEach(object -> names.add(object.getName()));
        return String.join(" ", names);
    }
}
