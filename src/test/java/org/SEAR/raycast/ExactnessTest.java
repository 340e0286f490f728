// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.HowMany;
import org.SEAR.Slow;
import org.SEAR.geometry.Pose;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Beams and fans compared with independently written geometry in random scenes. {@code -Dsear.beamWorlds=} sets their
 * number; the default is 200, or 1000 with {@code -Pfull}.
 */
@Category(Slow.class)
public class ExactnessTest {
    private static final int WORLDS = HowMany.of("sear.beamWorlds", 1000);
    private static final int BEAMS = 181;
    private static final double EXACT = 1e-9;
    /** Disturbance of a beam that shows whether it grazes an edge, radians and metres. */
    private static final double NUDGE = 1e-7;

    @Test
    public void beamsOfManyWorldsAgreeWithTheOracle() {
        for (long seed = 1; seed <= WORLDS; seed++) {
            RandomScenes world = new RandomScenes(seed);
            world.shapes(1 + world.random.nextInt(30), 4);
            for (int fan = 0; fan < 3; fan++) {
                compareFan(seed, world, world.pose(4), fan == 0 ? Math.toRadians(2) : Math.toRadians(1),
                    fan == 0 ? 6 : 50);
            }
        }
    }

    private void compareFan(long seed, RandomScenes world, Pose pose, double step, double range) {
        double start = world.between(-4, 4);
        double[] ranges = new double[BEAMS];
        int[] shapes = new int[BEAMS];
        world.scene.castFan(pose, start, step, BEAMS, range, BeamScene.WORLD, ranges, shapes);
        double[] o = {pose.x, pose.y, pose.z};
        Hit hit = new Hit();
        for (int i = 0; i < BEAMS; i++) {
            double angle = start + i * step;
            double[] d = pose.rotate(Math.sin(angle), 0, Math.cos(angle));
            double single = world.scene.cast(o[0], o[1], o[2], d[0], d[1], d[2], range, BeamScene.WORLD, hit);
            String beam = "seed " + seed + " from " + pose + " beam " + i + " of " + start + " + i * " + step;
            check(beam + ", single", world.oracle, o, d, range, single);
            check(beam + ", fan", world.oracle, o, d, range, ranges[i]);
            assertEquals(beam, ranges[i] < Double.POSITIVE_INFINITY, shapes[i] >= 0);
            if (single < Double.POSITIVE_INFINITY) {
                assertEquals(beam, single, hit.distance, 0);
                assertEquals(beam, 1, Math.sqrt(hit.nx * hit.nx + hit.ny * hit.ny + hit.nz * hit.nz), EXACT);
            }
        }
    }

    /** Checks within 1e-9 m; a grazing beam may also have the result of one of its disturbed copies. */
    private static void check(String beam, Oracle oracle, double[] o, double[] d, double range, double measured) {
        double expected = oracle.cast(o, d, range);
        if (expected == measured || Math.abs(expected - measured) <= EXACT) {
            return;
        }
        StringBuilder answers = new StringBuilder().append(expected);
        boolean same = false;
        for (int k = 0; k < 6; k++) {
            double[] nudge = {k == 0 ? NUDGE : k == 1 ? -NUDGE : 0, k == 2 ? NUDGE : k == 3 ? -NUDGE : 0, k == 4 ? NUDGE
                : k == 5 ? -NUDGE : 0};
            double other = oracle.cast(o, Oracle.add(d, nudge, 1), range + NUDGE);
            same |= other == measured || Math.abs(other - measured) < 1e3 * NUDGE;
            answers.append(' ').append(other);
        }
        assertTrue(beam + ": " + measured + ", expected " + answers, same);
    }
}
