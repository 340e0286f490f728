// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.urdf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.GuidedJoint;
import org.SEAR.POJOs.Inertia;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectSwap;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.embedded.Json;

/**
 * Prints of each URDF below a folder: mass, tensor and frame of each rigid body while the joints have positions within
 * their limits, and whether it still has finite poses after two simulated seconds; or why SEAR refuses it. {@code
 * src/test/pybullet/compare.py} compares the lines with PyBullet.
 */
public final class UrdfReport {
    private static final int STEPS = 120;

    private UrdfReport() {
    }

    /** @param arguments the folder */
    public static void main(String[] arguments) throws Exception {
        Path folder = Path.of(arguments[0]);
        List<Path> files;
        try (Stream<Path> all = Files.walk(folder)) {
            files = all.filter(file -> file.toString().endsWith(".urdf") && !file.toString().contains("random_urdfs"))
                .sorted().collect(Collectors.toList());
        }
        Path project = Files.createTempDirectory("urdf").resolve("SEARproject");
        System.setProperty("sear.project", project.toString());
        for (Path file : files) {
            ProjectSwap.delete(project);
            Map<String, Object> line = new LinkedHashMap<>();
            line.put("file", folder.relativize(file).toString());
            long start = System.nanoTime();
            try {
                report(file, project, line);
            } catch (Exception e) {
                line.put("error", String.valueOf(e.getMessage()));
            }
            line.put("seconds", (System.nanoTime() - start) / 1e9);
            System.out.println(Json.write(line));
        }
        System.exit(0);
    }

    private static void report(Path file, Path project, Map<String, Object> line) throws Exception {
        UrdfFile urdf = new UrdfFile(file.getFileName().toString(), Files.readAllBytes(file));
        Map<String, Double> positions = new LinkedHashMap<>();
        int number = 0;
        for (UrdfFile.UrdfJoint joint : urdf.joints.values()) {
            if (joint.hasAxis() && joint.mimics == null) {
                double low = joint.lower == null ? -1 : joint.lower;
                double high = joint.upper == null ? Math.max(1, low) : joint.upper;
                double position = low + (high - low) * (1 + ++number * 37 % 11) / 12;
                positions.put(joint.name, joint.isSlider() ? position : Math.toDegrees(position));
            }
        }
        List<String> notes = new ArrayList<>();
        String base = UrdfImport.add(file, project, Pose.IDENTITY, false, positions, notes);
        line.put("notes", notes);
        line.put("root", urdf.root.name);
        Project read = Project.read(project);
        Map<String, Double> joints = new LinkedHashMap<>();
        Map<String, String> links = new HashMap<>();
        Map<String, UrdfFile.UrdfJoint> named = new HashMap<>();
        urdf.joints.values().forEach(joint -> named.put(base + " " + UrdfImport.legal(joint.name), joint));
        read.getJoints().stream().filter(joint -> named.containsKey(joint.getName()))
            .forEach(joint -> links.put(joint.getSecond(), named.get(joint.getName()).child.name));
        read.getJoints().stream().filter(GuidedJoint.class::isInstance).map(GuidedJoint.class::cast)
            .forEach(joint -> joints.put(joint.getName().substring(base.length() + 1), joint.getStart()));
        Map<String, Double> inFile = new LinkedHashMap<>();
        urdf.joints.forEach((name, joint) -> {
            if (joint.hasAxis()) {
                double start = joints.getOrDefault(UrdfImport.legal(name), Double.NaN);
                inFile.put(name, joint.isSlider() ? start : Math.toRadians(start));
            }
        });
        line.put("joints", inFile);
        Map<String, Object> bodies = new LinkedHashMap<>();
        try (Simulation simulation = Simulation.load(project, 1)) {
            for (SEARrobot robot : read.getRobots()) {
                bodies.put(links.getOrDefault(robot.getName(), robot.getName().equals(base) ? ""
                    : robot.getName().substring(base.length() + 1)), body(robot, simulation.getPose(robot.getName())));
            }
            for (int i = 0; i < STEPS; i++) {
                simulation.step();
            }
            double far = 0;
            for (SEARrobot robot : read.getRobots()) {
                Pose pose = simulation.getPose(robot.getName());
                far = Math.max(far, Math.hypot(pose.x, pose.z));
            }
            line.put("far", far);
        }
        line.put("bodies", bodies);
    }

    /** Returns mass, pose and tensor about the frame of the body, in URDF's axes. */
    private static Object body(SEARrobot robot, Pose pose) throws IOException {
        Dynamics dynamics = (Dynamics) robot.getComponents().stream().filter(Dynamics.class::isInstance).findFirst()
            .orElseThrow();
        Inertia of = dynamics.getInertia();
        return List.of(dynamics.getMass(), List.of(pose.z, pose.x, pose.y, pose.qz, pose.qx, pose.qy, pose.qw),
            of == null ? List.of() : List.of(of.getZ(), of.getX(), of.getY(), of.getZz(), of.getXx(), of.getYy(),
                of.getXz(), of.getYz(), of.getXy()));
    }
}
