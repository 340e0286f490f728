// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.lang.management.ManagementFactory;
import org.SEAR.POJOs.Box;
import org.SEAR.simulator.BodyRun;

/** Scenes with crowded bodies at one spot: they cost a bounded time and separate slowly. */
final class CrowdScenes {
    private static final double SIZE = 0.2;

    private CrowdScenes() {
    }

    /** Puts all cubes at the same place. */
    static void oneSpot(int count, Findings into) throws Exception {
        crowd(count + " cubes at one spot", count, count, 0, 120, 1, into);
    }

    /** Makes a block of cubes, each of which overlaps the 26 around it. */
    static void block(int count, Findings into) throws Exception {
        crowd(count + " cubes inside each other", count, (int) Math.ceil(Math.cbrt(count)), 0.75 * SIZE, 60, 2, into);
    }

    private static void crowd(String scene, int count, int row, double apart, int steps, double seconds, Findings into)
        throws Exception {
        into.in(scene);
        try (Stage stage = new Stage(100)) {
            Cuboids cubes = new Cuboids();
            for (int i = 0; i < count; i++) {
                new Box("cube" + i, SIZE, SIZE, SIZE, 1, apart * (i % row), SIZE / 2 + apart * (i / (row * row)),
                    apart * (i / row % row));
                cubes.add("cube" + i, SIZE, SIZE, SIZE);
            }
            BodyRun run = stage.start();
            double fastest = 0;
            double longest = 0;
            double all = 0;
            for (int i = 0; i < steps; i++) {
                double before = seconds();
                run.step();
                double took = seconds() - before;
                all += took;
                longest = Math.max(longest, took);
                fastest = Math.max(fastest, cubes.fastest(run));
            }
            into.atMost("a step in the mean, CPU s", seconds / 2, all / steps);
            into.atMost("the longest step, CPU s", seconds, longest);
            into.atMost("the fastest, m/s: what was on top falls", 8, fastest);
        }
    }

    /** Returns the CPU time of this thread, seconds. */
    private static double seconds() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() * 1e-9;
    }
}
