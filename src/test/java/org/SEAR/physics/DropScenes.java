// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Gravity;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** Scenes of drops: single bodies end on a face or a side, bodies on a pile end at rest in it. */
final class DropScenes {
    private static final double APART = 1.5;
    private static final double FALL = 10;
    private static final double LANDING = 2;
    /** Deepest penetration at impact, metres: a corner may be detected some hundredths of a degree late. */
    private static final double DEEPEST_AT_IMPACT = 2e-3;
    private static final double DEEPEST = 5e-4;
    private static final double SIZE = 0.1;

    private DropScenes() {
    }

    /** Drops cubes, cylinders and cones of 5 to 30 cm, each alone on the floor. */
    static void single(int count, long seed, Findings into) throws Exception {
        Random random = new Random(seed);
        int row = (int) Math.ceil(Math.sqrt(count));
        try (Stage stage = new Stage(APART * row + 20)) {
            List<Dropped> things = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                things.add(new Dropped(i % 3, "thing" + i, APART * (i % row - row / 2),
                    APART * (i / row - row / 2), random));
            }
            BodyRun run = stage.start();
            into.in(count + " dropped singly, seed " + seed);
            double ever = 0;
            while (run.time() < FALL - Rest.WATCH) {
                run.step();
                for (Dropped thing : things) {
                    ever = Math.max(ever, -thing.lowest(run.pose(thing.name)));
                }
            }
            List<Pose> before = things.stream().map(thing -> run.pose(thing.name)).collect(Collectors.toList());
            run.run(Rest.WATCH);
            judge(things, before, run, into);
            into.atMost("deepest in the floor at any time, mm", 1000 * DEEPEST_AT_IMPACT, 1000 * ever);
        }
    }

    /**
     * Cubes of 10 to 30 cm land on their corners. Friction and contact impulses dissipate energy and never add any in a
     * step.
     */
    static void landing(int count, Findings into) throws Exception {
        Random random = new Random(1);
        int row = (int) Math.ceil(Math.sqrt(count));
        try (Stage stage = new Stage(APART * row + 20)) {
            double[] sizes = new double[count];
            for (int i = 0; i < count; i++) {
                sizes[i] = 0.1 + 0.2 * random.nextDouble();
                Box cube = new Box("cube" + i, sizes[i], sizes[i], sizes[i], 1);
                cube.rotate(360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
                cube.move(APART * (i % row - row / 2), 0.8 + 0.7 * random.nextDouble(), APART * (i / row - row / 2));
            }
            BodyRun run = stage.start();
            into.in("landing of " + count);
            double[] before = new double[count];
            double most = 0;
            run.step();
            while (run.time() < LANDING) {
                for (int i = 0; i < count; i++) {
                    before[i] = energy("cube" + i, sizes[i], run);
                }
                run.step();
                for (int i = 0; i < count; i++) {
                    most = Math.max(most, energy("cube" + i, sizes[i], run) / before[i] - 1);
                }
            }
            into.atMost("energy that a cube gains in a step, %", 10, 100 * most);
        }
    }

    /** Returns the energy per kg above the floor, J. */
    private static double energy(String cube, double size, BodyRun run) {
        double[] v = run.velocities(cube);
        return Gravity.EARTH * run.pose(cube).y + (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 2
            + size * size / 12 * (v[3] * v[3] + v[4] * v[4] + v[5] * v[5]);
    }

    private static void judge(List<Dropped> things, List<Pose> before, BodyRun run, Findings into) {
        double deepest = 0;
        int moving = 0;
        int wrong = 0;
        String first = "";
        for (int i = 0; i < things.size(); i++) {
            Pose pose = run.pose(things.get(i).name);
            deepest = Math.max(deepest, -things.get(i).lowest(pose));
            moving += Rest.hasMoved(before.get(i), pose) ? 1 : 0;
            if (!things.get(i).isSettled(pose)) {
                first = wrong++ == 0 ? " (first " + things.get(i).what + ")" : first;
            }
        }
        into.equal("on no face, rim or side", 0, wrong);
        into.note(first);
        into.equal("still moving after 10 s", 0, moving);
        into.atMost("deepest in the floor at the end, mm", 1000 * DEEPEST, 1000 * deepest);
    }

    /** Drops cubes of 10 cm onto one pile. */
    static void pile(int count, long seed, Findings into) throws Exception {
        Random random = new Random(seed);
        int row = count > 200 ? 8 : 4;
        try (Stage stage = new Stage(60)) {
            Cuboids cubes = new Cuboids();
            for (int i = 0; i < count; i++) {
                Box cube = new Box("cube" + i, SIZE, SIZE, SIZE, 1);
                cube.rotate(360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
                cube.move(0.13 * (i % row) + 0.02 * random.nextDouble(), 0.1 + 0.14 * (i / (row * row)),
                    0.13 * (i / row % row) + 0.02 * random.nextDouble());
                cubes.add("cube" + i, SIZE, SIZE, SIZE);
            }
            BodyRun run = stage.start();
            into.in("pile of " + count + ", seed " + seed);
            run.run(15 - Rest.WATCH);
            cubes.remember(run);
            run.run(Rest.WATCH);
            into.equal("still moving after 15 s", 0, cubes.moving(run));
            into.equal("looked at by the physics after 15 s", 0, run.busy());
            into.atMost("deepest overlap, mm", 1, 1000 * cubes.deepest(run));
        }
    }
}
