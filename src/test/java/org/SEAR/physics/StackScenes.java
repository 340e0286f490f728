// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.POJOs.Box;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** Stacks that must stay. */
final class StackScenes {
    private StackScenes() {
    }

    /** Ten boxes stand for a minute without sinking or creeping. */
    static void ten(Findings into) throws Exception {
        stack("stack of ten for 60 s", 10, 0.3, 0.2, 2, 60, 5e-4, into);
    }

    /** Forty boxes of 25 cm stand for half a minute. */
    static void forty(Findings into) throws Exception {
        stack("tower of forty for 30 s", 40, 0.25, 0.25, 1, 30, 5e-3, into);
    }

    private static void stack(String scene, int count, double side, double height, double mass, double seconds,
        double allowed, Findings into)
            throws Exception {
        try (Stage stage = new Stage(20)) {
            Cuboids boxes = new Cuboids();
            for (int i = 0; i < count; i++) {
                new Box("box" + i, side, side, height, mass).move(0, height * (i + 0.5), 0);
                boxes.add("box" + i, side, height, side);
            }
            BodyRun run = stage.start();
            into.in(scene);
            double top = 0;
            double drift = 0;
            double deepest = 0;
            while (run.time() < seconds) {
                run.run(0.5);
                top = Math.max(top, Math.abs(run.pose("box" + (count - 1)).y - height * (count - 0.5)));
                for (int i = 0; i < count; i++) {
                    Pose pose = run.pose("box" + i);
                    drift = Math.max(drift, Math.hypot(pose.x, pose.z));
                }
                deepest = Math.max(deepest, boxes.deepest(run));
            }
            into.atMost("top off its height at any time, mm", 1000 * allowed, 1000 * top);
            into.atMost("drift sideways at any time, mm", 1000 * allowed, 1000 * drift);
            into.atMost("deepest overlap at any time, mm", 0.5, 1000 * deepest);
            into.equal("looked at by the physics at the end", 0, run.busy());
        }
    }

    /** A cube of one mass carries a cube of another mass, both 30 cm. */
    static void masses(double below, double above, Findings into) throws Exception {
        double size = 0.3;
        try (Stage stage = new Stage(20)) {
            Cuboids cubes = new Cuboids();
            new Box("below", size, size, size, below).move(0, size / 2, 0);
            new Box("above", size, size, size, above).move(0, 1.5 * size, 0);
            cubes.add("below", size, size, size);
            cubes.add("above", size, size, size);
            BodyRun run = stage.start();
            into.in((int) above + " kg on " + (int) below + " kg for 10 s");
            double deepest = 0;
            double fastest = 0;
            while (run.time() < 10) {
                run.step();
                deepest = Math.max(deepest, cubes.deepest(run));
                fastest = Math.max(fastest, cubes.fastest(run));
            }
            into.atMost("deepest overlap at any time, mm", 1, 1000 * deepest);
            into.atMost("fastest at any time, m/s", 0.1, fastest);
            into.near("where the upper one ends, m", 1.5 * size, 1e-3, run.pose("above").y);
            into.near("how far aside it ends, m", 0, 1e-3, Math.hypot(run.pose("above").x, run.pose("above").z));
        }
    }

    /** A cube 1000 times as heavy is dropped from half a metre onto a light one. */
    static void dropOntoLight(Findings into) throws Exception {
        double size = 0.3;
        try (Stage stage = new Stage(20)) {
            Cuboids cubes = new Cuboids();
            new Box("below", size, size, size, 1).move(0, size / 2, 0);
            new Box("above", size, size, size, 1000).move(0, 1.5 * size + 0.5, 0);
            cubes.add("below", size, size, size);
            cubes.add("above", size, size, size);
            BodyRun run = stage.start();
            into.in("1000 kg dropped 0.5 m onto 1 kg");
            double fastest = 0;
            while (run.time() < 10) {
                run.step();
                fastest = Math.max(fastest, cubes.fastest(run));
            }
            into.atMost("fastest at any time, m/s", 3.5, fastest);
            into.atMost("deepest overlap at the end, mm", 1, 1000 * cubes.deepest(run));
            into.near("where the upper one ends, m", 1.5 * size, 1e-3, run.pose("above").y);
        }
    }
}
