// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.files;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.Pose;
import org.SEAR.grammar.Parameter;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * Sets the height of a robot that an edit with {@code "stand": true} moves in a running world, so that it stands on the
 * ground or object below. Any thread.
 */
final class GroundSnap {
    /** Least height change, metres; springs settle smaller ones. */
    private static final double STEP = 0.01;
    private static final double DIGITS = 1e4;

    private GroundSnap() {
    }

    /**
     * Returns the edit with the robot's height. Returns the edit unchanged if it moves no robot, or one that stands on
     * the ground anyway.
     *
     * @throws ProjectException if the project can't be read
     */
    static Map<?, ?> of(Map<?, ?> edit, SimulationSession session)
        throws IOException, ProjectException, InterruptedException {
        if (!"true".equals(String.valueOf(edit.get("stand"))) || !(edit.get("set") instanceof Map)) {
            return edit;
        }
        Map<Object, Object> set = new LinkedHashMap<>((Map<?, ?>) edit.get("set"));
        String name = String.valueOf(edit.get("object"));
        SEARrobot robot = Project.read(Projects.folder()).getRobots().stream().filter(one -> one.getName().equals(name))
            .findFirst().orElse(null);
        if (robot == null || robot.isOnGround() || set.containsKey("y")) {
            return edit;
        }
        Pose to;
        try {
            to = Pose.ofDegrees(number(set, "x", robot.getX()), robot.getY(), number(set, "z", robot.getZ()),
                number(set, "rx", robot.getRx()), number(set, "ry", robot.getRy()), number(set, "rz", robot.getRz()));
        } catch (NumberFormatException e) {
            return edit;        // the editor reports the problem
        }
        double rise = session.rise(name, to.times(inverse(ObjectPose.of(robot))));
        if (Math.abs(rise) >= STEP) {
            set.put("y", Parameter.format(Math.rint((robot.getY() + rise) * DIGITS) / DIGITS));
        }
        Map<Object, Object> whole = new LinkedHashMap<>(edit);
        whole.put("set", set);
        return whole;
    }

    private static double number(Map<?, ?> set, String name, double otherwise) {
        return set.containsKey(name) ? Double.parseDouble(String.valueOf(set.get(name))) : otherwise;
    }

    private static Pose inverse(Pose pose) {
        double[] at = pose.rotateBack(-pose.x, -pose.y, -pose.z);
        return new Pose(at[0], at[1], at[2], -pose.qx, -pose.qy, -pose.qz, pose.qw);
    }
}
