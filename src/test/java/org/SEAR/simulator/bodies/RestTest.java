// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.Progress;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Dropped or toppled objects come to rest on a face, not on an edge, in mid-air or in the floor. */
public class RestTest {
    private static final int THINGS = 200;
    private static final double APART = 1.5;
    /** Cosine of one degree. */
    private static final double FLAT = 0.99985;
    /** Deepest allowed penetration of a corner into the floor, metres. */
    private static final double DEEPEST = 5e-4;
    private static final int DOMINOES = 30;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private void floor() throws Exception {
        Bundle.newProject(project.folder(), Progress.NONE);
        new Floor("floor", 60, 60);
    }

    private static Box cube(String name, double size, Random random) {
        Box cube = new Box(name, size, size, size, 1);
        cube.rotate(360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
        return cube;
    }

    /** Returns the vertical component of each axis of a cube. */
    private static double[] upward(Pose pose) {
        return new double[] {Math.abs(pose.rotate(1, 0, 0)[1]), Math.abs(pose.rotate(0, 1, 0)[1]),
            Math.abs(pose.rotate(0, 0, 1)[1])};
    }

    private static void assertAboveTheFloor(String what, Pose pose, double size) {
        double[] upward = upward(pose);
        assertTrue(what + " at " + pose.y, pose.y - size / 2 * (upward[0] + upward[1] + upward[2]) > -DEEPEST);
    }

    private static void assertAtRest(Simulation simulation) {
        assertEquals("bodies that still move", 0, Worlds.physics(simulation).getBusyBodies());
    }

    @Test
    public void everyCubeThatIsDroppedEndsOnAFace() throws Exception {
        for (long seed = 1; seed <= 3; seed++) {
            Random random = new Random(seed);
            floor();
            double[] sizes = new double[THINGS];
            int row = (int) Math.ceil(Math.sqrt(THINGS));
            for (int i = 0; i < THINGS; i++) {
                sizes[i] = 0.05 + 0.25 * random.nextDouble();
                cube("cube" + i, sizes[i], random)
                    .move(APART * (i % row - row / 2), 0.5 + sizes[i], APART * (i / row - row / 2));
            }
            try (Simulation simulation = Worlds.start(project)) {
                Worlds.run(simulation, 10);
                for (int i = 0; i < THINGS; i++) {
                    Pose pose = simulation.getPose("cube" + i);
                    String what = "cube " + i + " of " + sizes[i] + ", seed " + seed;
                    double[] upward = upward(pose);
                    assertTrue(what + " stands on an edge", Math.max(upward[0], Math.max(upward[1], upward[2])) > FLAT);
                    assertAboveTheFloor(what, pose, sizes[i]);
                }
                assertAtRest(simulation);
            }
        }
    }

    @Test
    public void aPileComesToRestAboveTheFloor() throws Exception {
        Random random = new Random(1);
        floor();
        double size = 0.1;
        for (int i = 0; i < 100; i++) {
            cube("cube" + i, size, random).move(0.13 * (i % 4) + 0.02 * random.nextDouble(), 0.1 + 0.14 * (i / 16),
                0.13 * (i % 16 / 4) + 0.02 * random.nextDouble());
        }
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 15);
            for (int i = 0; i < 100; i++) {
                assertAboveTheFloor("cube " + i, simulation.getPose("cube" + i), size);
            }
            assertAtRest(simulation);
        }
    }

    @Test
    public void aRowOfDominoesFalls() throws Exception {
        for (double height : new double[] {0.1, 0.2}) {
            for (double gap : new double[] {0.3, 0.4, 0.5, 0.6}) {
                floor();
                for (int i = 1; i < DOMINOES; i++) {
                    new Box("domino" + i, height / 2, 0.15 * height, height, 0.1).move(0, height / 2, gap * height * i);
                }
                Box first = new Box("domino0", height / 2, 0.15 * height, height, 0.1);
                first.move(0, height / 2 * Math.cos(0.35) + 0.075 * height * Math.sin(0.35), -0.2 * height);
                first.rotate(20, 0, 0);
                try (Simulation simulation = Worlds.start(project)) {
                    Worlds.run(simulation, 10);
                    for (int i = 0; i < DOMINOES; i++) {
                        assertTrue("domino " + i + " of " + height + " m, each " + gap + " of that apart, stands",
                            Math.abs(simulation.getPose("domino" + i).rotate(0, 1, 0)[1]) < 0.9);
                    }
                    assertAtRest(simulation);
                }
            }
        }
    }
}
