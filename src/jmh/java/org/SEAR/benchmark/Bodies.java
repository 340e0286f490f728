package org.SEAR.benchmark;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Locale;

/**
 * Writes a scene of {@link RestWorld} as a JSON file for other engines, and what SEAR needs for it: processor time of the thread that steps, and
 * where all lies at the end, for others to judge. A scene that takes little runs several times, and the last counts: by then its code is compiled.
 */
public final class Bodies {
    private static final int MOST_RUNS = 40;
    /** No further run after so many seconds of processor time. */
    private static final double ENOUGH = 4;

    private Bodies() {
    }

    /** @param args the scene's name, the file for the scene, the file for SEAR's result, or none */
    public static void main(String[] args) throws IOException {
        try (RestWorld world = new RestWorld(args[0])) {
            Files.writeString(Paths.get(args[1]), String.format(Locale.ROOT,
                "{\"name\": \"%s\", \"side\": %s, \"mass\": %s, \"friction\": %s, \"seconds\": %s, \"watch\": %s, \"boxes\": %s}%n", args[0],
                world.side, RestWorld.MASS, RestWorld.FRICTION, world.seconds, RestWorld.WATCH, Arrays.deepToString(world.posed())));
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
        Files.writeString(into, String.format(Locale.ROOT, "{\"cpu\": %s, \"before\": %s, \"after\": %s}%n", took, Arrays.deepToString(before),
            Arrays.deepToString(world.poses())));
    }

    /** Processor time of this thread. */
    private static double seconds() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() * 1e-9;
    }
}
