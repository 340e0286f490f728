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

/**
 * What two threads and many robots make of it, everything in turns, so that a busy machine hits all alike. Arguments: JSON file, rounds, steps of a
 * robot in a round, and the fleets, such as {@code 10x1} for ten robots with a LIDAR each.
 */
public final class Cores {
    private static final int LIDARS = 8;
    private static final int READINGS = 60;
    private static final double MICRO = 1e3;

    private final int rounds;
    private final int robotSteps;
    private final List<String> found = new ArrayList<>();

    private Cores(int rounds, int robotSteps) {
        this.rounds = rounds;
        this.robotSteps = robotSteps;
    }

    /** @param args JSON file, rounds, steps of a robot in a round, fleets */
    public static void main(String[] args) throws IOException {
        Cores cores = new Cores(Integer.parseInt(args[1]), Integer.parseInt(args[2]));
        cores.lidars(false);
        cores.lidars(true);
        cores.fleets(Arrays.copyOfRange(args, 3, args.length));
        Files.write(Paths.get(args[0]), ("[" + String.join(",\n ", cores.found) + "]\n").getBytes(StandardCharsets.UTF_8));
    }

    private static double median(double... values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    /** Eight LIDARs that are due in the same step: microseconds until all are read, on one thread and on two. */
    private void lidars(boolean noise) {
        try (FleetWorld world = new FleetWorld(1, LIDARS, noise)) {
            double[][] micros = new double[2][rounds];
            double[] ratios = new double[rounds];
            for (int round = -rounds; round < rounds; round++) {
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
            found.add(String.format(Locale.ROOT, "{\"lidars\": %d, \"noise\": %b, \"one\": %.6g, \"two\": %.6g, \"ratio\": %.6g, \"best\": %.6g}",
                LIDARS, noise, median(micros[0]), median(micros[1]), median(ratios), best));
        }
    }

    /** Microseconds a step of processor time on one thread, and by the clock on one and on two. */
    private void fleets(String... names) {
        List<FleetWorld> worlds = new ArrayList<>();
        int[] robots = new int[names.length];
        double[][][] micros = new double[names.length][3][rounds];
        for (int i = 0; i < names.length; i++) {
            robots[i] = Integer.parseInt(names[i].substring(0, names[i].indexOf('x')));
            worlds.add(new FleetWorld(robots[i], Integer.parseInt(names[i].substring(names[i].indexOf('x') + 1)), false));
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
                        micros[i][0][slot] = (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - cpu) / MICRO / steps;
                    }
                }
            }
        }
        for (int i = 0; i < names.length; i++) {
            found.add(String.format(Locale.ROOT, "{\"fleet\": \"%s\", \"robots\": %d, \"cpu\": %.6g, \"one\": %.6g, \"two\": %.6g}", names[i],
                robots[i], median(micros[i][0]), median(micros[i][1]), median(micros[i][2])));
            worlds.get(i).close();
        }
    }
}
