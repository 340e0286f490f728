// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.Simulation;

/**
 * Mechanisms of boxes and hinges: {@code chain-N}, N links from the horizontal; {@code hoist-N}, the same links at 30
 * degrees with a load of 1 kg; {@code arm-7}, seven hinges with springs and dampers, from the horizontal; {@code
 * quadruped-12}, four legs of three hinges with springs and dampers, which falls 20 mm onto a floor. Boxes are not
 * rotated at the start.
 */
final class JointWorld implements AutoCloseable {
    private static final double HEIGHT = 3;
    private static final double LINK = 0.1;
    private static final double LINK_MASS = 0.1;
    private static final double LOSS = 0.001;

    /** Simulated time, seconds. */
    final double seconds;
    /** Half sizes, mass and centre of each box. */
    private final List<double[]> boxes = new ArrayList<>();
    /** Parent (-1 for the world), child, anchor, axis (0 to 2), spring rate, damping, all about that axis. */
    private final List<double[]> hinges = new ArrayList<>();
    private final boolean onFloor;
    private final BenchmarkProject project;

    /** Creates the project. */
    JointWorld(String name) {
        String kind = name.substring(0, name.indexOf('-'));
        int number = Integer.parseInt(name.substring(name.indexOf('-') + 1));
        onFloor = kind.equals("quadruped");
        switch (kind) {
            case "chain":
                chain(number, 0);
                seconds = 1;
                break;
            case "hoist":
                chain(number, 1);
                seconds = 5;
                break;
            case "arm":
                arm(number);
                seconds = 3;
                break;
            case "quadruped":
                quadruped();
                seconds = 2;
                break;
            default:
                throw new IllegalArgumentException("mechanism " + kind + ", legal: chain, hoist, arm, quadruped");
        }
        project = new BenchmarkProject(null, this::build);
    }

    private void chain(int number, double load) {
        double[] step = load > 0 ? new double[] {LINK / 2, -LINK * Math.sqrt(0.75)} : new double[] {LINK, 0};
        double size = load > 0 ? 0.005 : LINK / 2;
        for (int i = 0; i < number; i++) {
            boxes.add(new double[] {size, 0.005, 0.005, LINK_MASS, (i + 0.5) * step[0], HEIGHT + (i + 0.5) * step[1],
                0});
            hinges.add(new double[] {i - 1, i, i * step[0], HEIGHT + i * step[1], 0, 2, 0, LOSS});
        }
        if (load > 0) {
            boxes.add(new double[] {0.05, 0.05, 0.05, load, number * step[0], HEIGHT + number * step[1], 0});
            hinges.add(new double[] {number - 1, number, number * step[0], HEIGHT + number * step[1], 0, 2, 0, LOSS});
        }
    }

    private void arm(int number) {
        for (int i = 0; i < number; i++) {
            double length = 0.2;
            boxes.add(new double[] {length / 2, 0.03, 0.03, 1.5 - 0.15 * i, (i + 0.5) * length, HEIGHT, 0});
            hinges.add(new double[] {i - 1, i, i * length, HEIGHT, 0, i % 2 == 0 ? 2 : 1, 40 - 5 * i, 1});
        }
    }

    private void quadruped() {
        double hip = 0.42;
        boxes.add(new double[] {0.2, 0.04, 0.08, 6, 0, hip, 0});
        for (int leg = 0; leg < 4; leg++) {
            double x = leg % 2 == 0 ? 0.17 : -0.17;
            double z = leg < 2 ? 0.13 : -0.13;
            int at = boxes.size();
            boxes.add(new double[] {0.03, 0.03, 0.02, 0.3, x, hip, z});
            boxes.add(new double[] {0.02, 0.09, 0.02, 0.4, x, hip - 0.11, z + Math.signum(z) * 0.05});
            boxes.add(new double[] {0.015, 0.09, 0.015, 0.2, x, hip - 0.31, z + Math.signum(z) * 0.05});
            hinges.add(new double[] {0, at, x, hip, z, 0, 120, 2});
            hinges.add(new double[] {at, at + 1, x, hip, z + Math.signum(z) * 0.05, 2, 120, 2});
            hinges.add(new double[] {at + 1, at + 2, x, hip - 0.2, z + Math.signum(z) * 0.05, 2, 120, 2});
        }
    }

    private void build() {
        if (onFloor) {
            new Floor("floor", 10, 10);
        }
        List<SearObject> links = new ArrayList<>();
        for (int i = 0; i < boxes.size(); i++) {
            double[] box = boxes.get(i);
            links.add(new Box("link" + i, 2 * box[0], 2 * box[2], 2 * box[1], box[3], box[4], box[5], box[6], 0, 0, 0));
        }
        for (int i = 0; i < hinges.size(); i++) {
            double[] hinge = hinges.get(i);
            Hinge joint = new Hinge("hinge" + i, hinge[0] < 0 ? null : links.get((int) hinge[0]),
                links.get((int) hinge[1]), hinge[2], hinge[3], hinge[4], hinge[5] == 2 ? 90 : 0, 0,
                hinge[5] == 0 ? -90 : 0);
            joint.setDamping(hinge[7]);
            if (hinge[6] > 0) {
                joint.setSpring(hinge[6], 0);
            }
        }
    }

    /** Returns the mechanism as JSON. */
    String json(String name) {
        return String.format(Locale.ROOT, "{\"name\": \"%s\", \"seconds\": %s, \"floor\": %s, \"boxes\": %s, "
            + "\"hinges\": %s}%n", name, seconds, onFloor, rows(boxes), rows(hinges));
    }

    private static String rows(List<double[]> rows) {
        List<String> texts = new ArrayList<>();
        rows.forEach(row -> texts.add(Arrays.toString(row)));
        return texts.toString();
    }

    void reset() {
        project.getSimulation().reset();
    }

    /** Performs all steps. Returns the position of the marked box after each step, metres. */
    double[][] run() {
        String marked = "link" + (onFloor ? 0 : boxes.size() - 1);
        double[][] track = new double[(int) Math.round(seconds / Simulation.STEP)][];
        for (int i = 0; i < track.length; i++) {
            project.getSimulation().step();
            Pose pose = project.getSimulation().getPose(marked);
            track[i] = new double[] {pose.x, pose.y, pose.z};
        }
        return track;
    }

    @Override
    public void close() {
        project.close();
    }
}
