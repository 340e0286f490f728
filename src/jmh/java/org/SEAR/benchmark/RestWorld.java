// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.Simulation;

/**
 * Bodies that come to rest: {@code single-N}, N cubes of 0.1 to 0.3 m dropped separately; {@code pile-N}, the same
 * cubes dropped onto one pile; {@code dominoes-N}, a row with the first one tilted; {@code stack-N}, boxes on top of
 * each other. Structures: {@code wall-N}, N rows of ten bricks in running bond; {@code bond-N}, the same in stack bond;
 * {@code pyramid-N}, N rows of cubes; {@code jenga-N}, N storeys of three; {@code logs-N}, N rows of cylinders. Each
 * body has 1 kg and friction 0.64. Equal names give equal scenes.
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
    /** Bricks in a row of a wall, and blocks in a storey of a Jenga tower. */
    private static final int BRICKS = 10;
    private static final int STOREY = 3;
    /** Width of a joint between bricks, metres; the bricks of a running bond are off by up to as much. */
    private static final double JOINT = 0.002;
    /** Sizes of a brick and of a Jenga block, diameter of a log, and size of a pyramid's cube, metres. */
    private static final double[] BRICK = {0.24, 0.071, 0.115};
    private static final double[] BLOCK = {0.025, 0.015, 0.075};
    private static final double LOG = 0.2;
    private static final double CUBE = 0.1;

    /** Length of the square floor's side, metres; its top is at height 0. */
    final double side;
    /** Simulated time until all bodies are at rest, seconds. */
    final double seconds;
    /** Nine numbers per box, as in {@link Room}; of a log those of the box around it. */
    final double[][] boxes;
    /** Whether all bodies are cylinders along their y axes. */
    final boolean round;
    private final BenchmarkProject project;

    /** Creates the project. */
    RestWorld(String name) {
        String kind = name.substring(0, name.indexOf('-'));
        int number = Integer.parseInt(name.substring(name.indexOf('-') + 1));
        Random random = new Random(2026);
        List<double[]> made = structure(kind, number, random);
        for (int i = 0; i < number && made.size() <= i; i++) {
            made.add(box(kind, i, number, random));
        }
        boxes = made.toArray(new double[0][]);
        round = kind.equals("logs");
        side = kind.equals("single") ? APART * (Math.ceil(Math.sqrt(number)) + 2) : 60;
        seconds = kind.equals("pile") ? 15 : 10;
        project = new BenchmarkProject(null, () -> {
            new Floor("floor", side, side);
            for (int i = 0; i < boxes.length; i++) {
                double[] b = boxes[i];
                if (round) {
                    new Cylinder("box" + i, b[0] / 2, b[1], MASS, b[3], b[4], b[5], b[6], b[7], b[8]);
                } else {
                    Room.add("box" + i, b, MASS);
                }
            }
        });
    }

    /** Returns the bodies of a structure; none for other kinds. */
    private static List<double[]> structure(String kind, int rows, Random random) {
        List<double[]> made = new ArrayList<>();
        for (int row = 0; row < rows; row++) {
            for (int i = 0; i < across(kind, row, rows); i++) {
                made.add(body(kind, row, i, random));
            }
        }
        return made;
    }

    /** Returns the number of bodies in a row of a structure; 0 for other kinds. */
    private static int across(String kind, int row, int rows) {
        switch (kind) {
            case "wall":
                return BRICKS + row % 2;
            case "bond":
                return BRICKS;
            case "pyramid":
            case "logs":
                return rows - row;
            case "jenga":
                return STOREY;
            default:
                return 0;
        }
    }

    private static double[] body(String kind, int row, int i, Random random) {
        switch (kind) {
            case "pyramid":
                return new double[] {CUBE, CUBE, CUBE, 1.05 * CUBE * (i + row / 2.0), (row + 0.5) * CUBE, 0, 0, 0, 0};
            case "logs":
                return new double[] {LOG, 1, LOG, LOG * (i + row / 2.0), LOG / 2 + row * LOG * Math.sqrt(0.75), 0,
                    90, 0, 0};
            case "jenga":
                return block(row, i);
            case "wall":
                return brick(row, i, JOINT * (2 * random.nextDouble() - 1), row % 2 == 1);
            default:
                return brick(row, i, 0, false);
        }
    }

    private static double[] block(int storey, int i) {
        double at = 1.02 * BLOCK[0] * (i - 1);
        double y = (storey + 0.5) * BLOCK[1];
        return storey % 2 == 0 ? new double[] {BLOCK[0], BLOCK[1], BLOCK[2], at, y, 0, 0, 0, 0}
            : new double[] {BLOCK[2], BLOCK[1], BLOCK[0], 0, y, at, 0, 0, 0};
    }

    /**
     * Returns a brick; those at the ends of every other row of a running bond are halves.
     * @param z of its centre, metres
     */
    private static double[] brick(int row, int i, double z, boolean shifted) {
        boolean half = shifted && (i == 0 || i == BRICKS);
        double x = !shifted ? i : i == 0 ? -0.25 : i == BRICKS ? BRICKS - 0.75 : i - 0.5;
        return new double[] {(half ? BRICK[0] / 2 : BRICK[0]) - JOINT, BRICK[1], BRICK[2], x * BRICK[0],
            (row + 0.5) * BRICK[1], z, 0, 0, 0};
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
                throw new IllegalArgumentException("scene " + kind + ", legal: single, pile, dominoes, stack, wall,"
                    + " bond, pyramid, jenga, logs");
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
