// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.util.Random;
import org.SEAR.POJOs.Floor;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.Simulation;

/**
 * Bodies that come to rest: {@code single-N}, N cubes of 0.1 to 0.3 m dropped separately; {@code pile-N}, the same
 * cubes dropped onto one pile; {@code dominoes-N}, a row with the first one tilted; {@code stack-N}, boxes on top of
 * each other. Each has 1 kg and friction 0.64. Equal names give equal scenes.
 */
final class RestWorld implements AutoCloseable {
    static final double MASS = 1;
    /** Friction coefficient of a contact between two bodies. */
    static final double FRICTION = 0.64;
    /** Time between the two samples at the end that detect motion, seconds. */
    static final double WATCH = 0.5;
    private static final double APART = 1.2;
    private static final double MESH = 0.32;
    private static final double DOMINO = 0.2;

    /** Length of the square floor's side, metres; its top is at height 0. */
    final double side;
    /** Simulated time until all bodies are at rest, seconds. */
    final double seconds;
    /** Nine numbers per box, as in {@link Room}. */
    final double[][] boxes;
    private final BenchmarkProject project;

    /** Creates the project. */
    RestWorld(String name) {
        String kind = name.substring(0, name.indexOf('-'));
        int number = Integer.parseInt(name.substring(name.indexOf('-') + 1));
        boxes = new double[number][];
        Random random = new Random(2026);
        for (int i = 0; i < number; i++) {
            boxes[i] = box(kind, i, number, random);
        }
        side = kind.equals("single") ? APART * (Math.ceil(Math.sqrt(number)) + 2) : 60;
        seconds = kind.equals("pile") ? 15 : 10;
        project = new BenchmarkProject(null, () -> {
            new Floor("floor", side, side);
            for (int i = 0; i < boxes.length; i++) {
                Room.add("box" + i, boxes[i], MASS);
            }
        });
    }

    private static double[] box(String kind, int i, int number, Random random) {
        switch (kind) {
            case "single":
                int row = (int) Math.ceil(Math.sqrt(number));
                return cube(APART * (i / row - (row - 1) / 2.0), 0.8 + 0.7 * random.nextDouble(),
                    APART * (i % row - (row - 1) / 2.0), random);
            case "pile":
                int across = number > 200 ? 8 : 4;
                return cube(MESH * (i % across) + 0.02 * random.nextDouble(), 0.3 + MESH * (i / (across * across)),
                    MESH * (i / across % across) + 0.02 * random.nextDouble(), random);
            case "dominoes":
                double[] domino = {DOMINO / 2, DOMINO, 0.15 * DOMINO, 0, DOMINO / 2, 0.4 * DOMINO * i, 0, 0, 0};
                return i > 0 ? domino : new double[] {domino[0], domino[1], domino[2], 0,
                    domino[1] / 2 * Math.cos(0.35) + domino[2] / 2 * Math.sin(0.35), -0.2 * DOMINO, 20, 0, 0};
            case "stack":
                return new double[] {0.3, 0.2, 0.3, 0, 0.1 + 0.2 * i, 0, 0, 0, 0};
            default:
                throw new IllegalArgumentException("scene " + kind + ", legal: single, pile, dominoes, stack");
        }
    }

    private static double[] cube(double x, double y, double z, Random random) {
        double size = 0.1 + 0.2 * random.nextDouble();
        return new double[] {size, size, size, x, y, z, 360 * random.nextDouble(), 360 * random.nextDouble(),
            360 * random.nextDouble()};
    }

    /** Returns half sizes, position and quaternion of each box at the start. */
    double[][] posed() {
        double[][] posed = new double[boxes.length][];
        for (int i = 0; i < posed.length; i++) {
            posed[i] = Room.posed(boxes[i]);
        }
        return posed;
    }

    void reset() {
        project.getSimulation().reset();
    }

    void run(double time) {
        for (long i = Math.round(time / Simulation.STEP); i > 0; i--) {
            project.getSimulation().step();
        }
    }

    /** Returns the present position and quaternion of each box. */
    double[][] poses() {
        double[][] poses = new double[boxes.length][];
        for (int i = 0; i < poses.length; i++) {
            Pose pose = project.getSimulation().getPose("box" + i);
            poses[i] = new double[] {pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw};
        }
        return poses;
    }

    @Override
    public void close() {
        project.close();
    }
}
