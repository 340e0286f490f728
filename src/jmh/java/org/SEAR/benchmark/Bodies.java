// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Locale;

/**
 * Writes a scene of {@link RestWorld} as JSON for other engines, and SEAR's result: processor time of the stepping
 * thread and final poses. Short scenes run repeatedly and the last run counts, when the code is compiled.
 */
public final class Bodies {
    private static final int MOST_RUNS = 40;
    /** Processor time after which no further run starts, seconds. */
    private static final double ENOUGH = 4;

    private Bodies() {
    }

    /** @param args scene name, file for the scene, and optionally file for SEAR's result */
    public static void main(String[] args) throws IOException {
        try (RestWorld world = new RestWorld(args[0])) {
            Files.writeString(Paths.get(args[1]), String.format(Locale.ROOT,
                "{\"name\": \"%s\", \"side\": %s, \"mass\": %s, \"friction\": %s, \"seconds\": %s, \"watch\": %s, "
                + "\"round\": %d, \"boxes\": %s}%n", args[0], world.side, RestWorld.MASS, RestWorld.FRICTION,
                world.seconds, RestWorld.WATCH, world.round ? 1 : 0, Arrays.deepToString(world.posed())));
            if (args.length > 2) {
                measure(world, Paths.get(args[2]));
            }
        }
    }

    private static void measure(RestWorld world, Path into) throws IOException {
        double all = 0;
        double took = 0;
        double[][] before = null;
        for (int i = 0; i < MOST_RUNS && all < ENOUGH; i++) {
            if (i > 0) {
                world.reset();
            }
            double from = seconds();
            world.run(world.seconds - RestWorld.WATCH);
            took = seconds() - from;
            before = world.poses();
            from = seconds();
            world.run(RestWorld.WATCH);
            took += seconds() - from;
            all += took;
        }
        Files.writeString(into, String.format(Locale.ROOT, "{\"cpu\": %s, \"before\": %s, \"after\": %s}%n", took,
            Arrays.deepToString(before), Arrays.deepToString(world.poses())));
    }

    /** Returns the processor time of this thread, seconds. */
    private static double seconds() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() * 1e-9;
    }
}
