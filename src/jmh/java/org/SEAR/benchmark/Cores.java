// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.simulator.Simulation;

/**
 * Measures the gain from two threads and the cost of many robots, alternating all cases so that other load affects them
 * equally. Arguments: JSON file, rounds, steps of a robot per round, and the fleets, such as {@code 10x1} for ten
 * robots with a LIDAR each.
 */
public final class Cores {
    private static final int LIDARS = 8;
    private static final int READINGS = 60;
    private static final double MICRO = 1e3;
    /** Warm-up time per counted round, ns: compilation would occupy the second core. */
    private static final long WARM_UP = 100_000_000;

    private final int rounds;
    private final int robotSteps;
    private final List<String> found = new ArrayList<>();

    private Cores(int rounds, int robotSteps) {
        this.rounds = rounds;
        this.robotSteps = robotSteps;
    }

    /** @param args JSON file, rounds, steps of a robot per round, fleets */
    public static void main(String[] args) throws IOException {
        Cores cores = new Cores(Integer.parseInt(args[1]), Integer.parseInt(args[2]));
        cores.lidars(false);
        cores.lidars(true);
        cores.fleets(Arrays.copyOfRange(args, 3, args.length));
        Files.write(Paths.get(args[0]), ("[" + String.join(",\n ", cores.found) + "]\n")
            .getBytes(StandardCharsets.UTF_8));
    }

    private static double median(double... values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    /** Measures eight LIDARs due in the same step: microseconds to read all, on one and two threads. */
    private void lidars(boolean noise) {
        try (FleetWorld world = new FleetWorld(1, LIDARS, noise)) {
            double[][] micros = new double[2][rounds];
            double[] ratios = new double[rounds];
            long warm = System.nanoTime() + rounds * WARM_UP;
            for (int round = -1; round < rounds; round += System.nanoTime() > warm ? 1 : 0) {
                double[] now = new double[2];
                for (int threads = 1; threads <= 2; threads++) {
                    world.getSimulation().setThreads(threads);
                    double[] each = new double[READINGS];
                    for (int i = 0; i < READINGS; i++) {
                        each[i] = world.readAfterStep() / MICRO;
                    }
                    now[threads - 1] = median(each);
                }
                if (round >= 0) {
                    micros[0][round] = now[0];
                    micros[1][round] = now[1];
                    ratios[round] = now[0] / now[1];
                }
            }
            double best = Arrays.stream(ratios).max().orElse(0);
            found.add(String.format(Locale.ROOT, "{\"lidars\": %d, \"noise\": %b, \"one\": %.6g, \"two\": %.6g, "
                + "\"ratio\": %.6g, \"best\": %.6g}",
                LIDARS, noise, median(micros[0]), median(micros[1]), median(ratios), best));
        }
    }

    /** Measures microseconds per step: processor time on one thread, and wall time on one and two. */
    private void fleets(String... names) {
        List<FleetWorld> worlds = new ArrayList<>();
        int[] robots = new int[names.length];
        double[][][] micros = new double[names.length][3][rounds];
        for (int i = 0; i < names.length; i++) {
            robots[i] = Integer.parseInt(names[i].substring(0, names[i].indexOf('x')));
            worlds.add(new FleetWorld(robots[i],
                Integer.parseInt(names[i].substring(names[i].indexOf('x') + 1)), false));
        }
        for (int round = -rounds; round < rounds; round++) {
            for (int i = 0; i < names.length; i++) {
                int steps = Math.max(StepWorld.SCAN_EVERY, robotSteps / robots[i]);
                for (int threads = 1; threads <= 2; threads++) {
                    worlds.get(i).getSimulation().setThreads(threads);
                    long cpu = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
                    long wall = System.nanoTime();
                    for (int step = 0; step < steps; step++) {
                        worlds.get(i).step();
                    }
                    int slot = Math.max(0, round);
                    micros[i][threads][slot] = (System.nanoTime() - wall) / MICRO / steps;
                    if (threads == 1) {
                        micros[i][0][slot] = (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - cpu)
                            / MICRO / steps;
                    }
                }
            }
        }
        for (int i = 0; i < names.length; i++) {
            found.add(String.format(Locale.ROOT, "{\"fleet\": \"%s\", \"robots\": %d, \"cpu\": %.6g, \"one\": %.6g, "
                + "\"two\": %.6g}", names[i],
                robots[i], median(micros[i][0]), median(micros[i][1]), median(micros[i][2])));
            worlds.get(i).close();
        }
    }

    /**
     * Many robots in one hall. Each robot drives in circles in its own area of 10 m x 10 m with 20 boxes, without walls
     * between areas. Its LIDARs have 361 beams and a range of 8 m. All LIDARs are read in the same step, ten times per
     * simulated second.
     */
    private static final class FleetWorld implements AutoCloseable {
        private static final double CELL = 10;
        private static final int BOXES = 20;
        private static final double CLEAR = 2.3;
        private static final double WALL = 0.1;
        private static final double WALL_HEIGHT = 2;

        private final BenchmarkProject project;
        private final Simulation simulation;
        private final List<String> sensors;

        /**
         * Creates the project.
         * @param robots number of robots
         * @param lidars number of LIDARs per robot
         * @param noise whether the LIDARs have noise
         */
        FleetWorld(int robots, int lidars, boolean noise) {
            project = new BenchmarkProject(null, () -> build(robots, lidars, noise));
            simulation = project.getSimulation();
            sensors = simulation.getSensorNames();
            simulation.post(world -> world.getRobots()
                .forEach(robot -> robot.drive(StepWorld.SPEED, StepWorld.CIRCLE)));
        }

        private static void build(int robots, int lidars, boolean noise) {
            int columns = (int) Math.ceil(Math.sqrt(robots));
            int rows = (robots + columns - 1) / columns;
            double width = columns * CELL;
            double depth = rows * CELL;
            new Floor("floor", width, depth);
            for (int side = -1; side <= 1; side += 2) {
                Room.add("wallx" + side, new double[] {WALL, WALL_HEIGHT, depth, side * width / 2, WALL_HEIGHT / 2, 0,
                    0, 0, 0}, 0);
                Room.add("wallz" + side, new double[] {width, WALL_HEIGHT, WALL, 0, WALL_HEIGHT / 2, side * depth / 2,
                    0, 0, 0}, 0);
            }
            Random random = new Random(2026);
            for (int i = 0; i < robots; i++) {
                double x = (i % columns + 0.5) * CELL - width / 2;
                double z = (i / columns + 0.5) * CELL - depth / 2;
                for (int k = 0; k < BOXES; k++) {
                    box("box" + i + "-" + k, x, z, random);
                }
                robot("robot" + i, x, z, lidars, noise);
            }
        }

        private static void box(String name, double middleX, double middleZ, Random random) {
            double x;
            double z;
            do {
                x = (random.nextDouble() - 0.5) * (CELL - 1);
                z = (random.nextDouble() - 0.5) * (CELL - 1);
            } while (Math.hypot(x, z) < CLEAR);
            double[] sizes = random.doubles(3, 0.25, 1).toArray();
            double[] turned = random.doubles(3, 0, 360).toArray();
            Room.add(name, new double[] {sizes[0], sizes[1], sizes[2], middleX + x, 0.5, middleZ + z, turned[0],
                turned[1], turned[2]}, 0);
        }

        private static void robot(String name, double x, double z, int lidars, boolean noise) {
            SEARrobot robot = new SEARrobot(name);
            robot.addComponent(new Dynamics(name + "Dynamics", 40, 60, 0.3, 0.4, 10000, 0.1, x - StepWorld.CIRCLE,
                StepWorld.START_HEIGHT, z, 0, 0, 0));
            robot.addComponent(new Cylinder(name + "Body", 0.1666875, 0.0762, 40));
            robot.addWheel(new Wheel(name + "Front", 0.0381, 0.03, 0, 0, 0, 0.16));
            robot.addWheel(new Wheel(name + "Right", 0.0381, 0.03, 1, -0.16, 0, 0));
            robot.addWheel(new Wheel(name + "Left", 0.0381, 0.03, 1, 0.16, 0, 0));
            robot.addWheel(new Wheel(name + "Back", 0.0381, 0.03, 0, 0, 0, -0.16));
            for (int i = 0; i < lidars; i++) {
                LIDAR lidar = new LIDAR(name + "Lidar" + i, StepWorld.RANGE, 180, 0.5, 0, StepWorld.LIDAR_HEIGHT
                    + i * StepWorld.LIDAR_PITCH, 0, 0, 360.0 * i / lidars, 0);
                if (noise) {
                    lidar.setNoise(new Noise().setWhite(0.01));
                }
                robot.addComponent(lidar);
            }
        }

        /** Steps and reads as a script would. */
        void step() {
            simulation.step();
            if (simulation.getStep() % StepWorld.SCAN_EVERY == 0) {
                simulation.read(sensors);
            }
        }

        /** Steps, reads all LIDARs and returns the reading time, ns. */
        long readAfterStep() {
            simulation.step();
            long from = System.nanoTime();
            simulation.read(sensors);
            return System.nanoTime() - from;
        }

        Simulation getSimulation() {
            return simulation;
        }

        @Override
        public void close() {
            project.close();
        }
    }
}
