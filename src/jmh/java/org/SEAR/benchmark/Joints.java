// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;

/**
 * Writes a mechanism of {@link JointWorld} as JSON for other engines, and SEAR's result: processor time of the stepping
 * thread per simulated second, and the path of the marked box. The mechanism runs repeatedly and the last run counts,
 * when the code is compiled.
 */
public final class Joints {
    private static final int MOST_RUNS = 60;
    /** Processor time after which no further run starts, seconds. */
    private static final double ENOUGH = 4;

    private Joints() {
    }

    /** @param args name of the mechanism, file for it, and file for SEAR's result */
    public static void main(String[] args) throws IOException {
        try (JointWorld world = new JointWorld(args[0])) {
            Files.writeString(Path.of(args[1]), world.json(args[0]));
            double[][] track = {};
            double took = 0;
            double all = 0;
            for (int i = 0; i < MOST_RUNS && all < ENOUGH; i++) {
                world.reset();
                long from = nanos();
                track = world.run();
                took = (nanos() - from) * 1e-9;
                all += took;
            }
            Files.writeString(Path.of(args[2]), String.format(Locale.ROOT, "{\"cpu\": %s, \"track\": %s}%n",
                took / world.seconds, Arrays.deepToString(track)));
        }
    }

    private static long nanos() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }
}
