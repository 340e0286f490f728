// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/** The points of a mesh that support a body. */
public class SupportPointsTest {
    private static final int SEED = 7;

    private final Random random = new Random(SEED);
    private final ContactPoints points = new ContactPoints();
    private final SupportPoints support = new SupportPoints();

    private List<double[]> choose(List<double[]> from, boolean ball) {
        return choose(from, ball, false);
    }

    private List<double[]> choose(List<double[]> from, boolean ball, boolean fast) {
        points.clear();
        for (double[] p : from) {
            points.add(p[0], p[1], p[2], p[3], p[4], p[5], p[6]);
        }
        support.choose(points, ball, fast);
        List<double[]> chosen = new ArrayList<>();
        for (int k = 0; k < support.size(); k++) {
            assertTrue("points of a manifold", support.size(k) > 0 && support.size(k) <= 4);
            for (int i = 0; i < support.size(k); i++) {
                chosen.add(from.get(support.get(k, i)));
            }
        }
        return chosen;
    }

    private static double[] at(double x, double z, double height) {
        return new double[] {0, 1, 0, x, 0, z, height};
    }

    @Test
    public void aFlatMeshOfManyPointsSupportsABoxAtItsFourCorners() {
        List<double[]> all = new ArrayList<>();
        for (int i = 0; i <= 20; i++) {
            for (int k = 0; k <= 30; k++) {
                all.add(at(i / 20.0, k / 30.0, 1e-8 * random.nextDouble()));
            }
        }
        List<double[]> chosen = choose(all, false);
        assertEquals(4, chosen.size());
        for (double[] p : chosen) {
            assertTrue(p[3] % 1 == 0 && p[5] % 1 == 0);
        }
    }

    /** The corners of a tilted face: only one touches soon, but a fast body must not turn past the others. */
    @Test
    public void aFastBodyGetsAllCorners() {
        List<double[]> all = List.of(at(0, 0, 0.01), at(0.1, 0, 0.02), at(0, 0.1, 0.02), at(0.1, 0.1, 0.03));
        assertEquals(1, choose(all, false, false).size());
        assertEquals(4, choose(all, false, true).size());
    }

    @Test
    public void threeSupportingBumpsAreChosenAmongMany() {
        List<double[]> all = new ArrayList<>();
        for (int i = 0; i < 300; i++) {
            all.add(at(random.nextDouble(), random.nextDouble(), 1e-3 + 1e-3 * random.nextDouble()));
        }
        double[][] bumps = {at(0.2, 0.3, 0), at(0.8, 0.4, 0), at(0.5, 0.9, 0)};
        for (double[] bump : bumps) {
            all.add(random.nextInt(all.size()), bump);
        }
        List<double[]> chosen = choose(all, false);
        for (double[] bump : bumps) {
            assertTrue("seed " + SEED, chosen.contains(bump));
        }
    }

    @Test
    public void theFacesNearestToABallAreChosen() {
        List<double[]> all = new ArrayList<>();
        for (int i = 0; i < 100; i++) {
            double angle = 0.01 * (i - 50);
            all.add(new double[] {Math.sin(angle), Math.cos(angle), 0, angle, 0, 0, angle * angle});
        }
        List<double[]> chosen = choose(all, true);
        assertEquals(16, chosen.size());
        for (double[] p : chosen) {
            assertTrue("height " + p[6], p[6] <= 0.08 * 0.08 + 1e-9);
        }
        assertEquals(0, chosen.get(0)[6], 1e-12);
    }

    @Test
    public void theOrderOfThePointsDoesNotCount() {
        for (int round = 0; round < 50; round++) {
            List<double[]> all = new ArrayList<>();
            for (int i = 0; i < 200; i++) {
                double tilt = 0.05 * random.nextInt(4);
                // few different heights and positions, so that many are equal
                all.add(new double[] {Math.sin(tilt), Math.cos(tilt), 0, random.nextInt(5) / 5.0, 0,
                    random.nextInt(5) / 5.0, random.nextInt(3) * 1e-4});
            }
            List<double[]> first = choose(all, round % 2 == 0, round % 3 == 0);
            Collections.shuffle(all, random);
            List<double[]> second = choose(all, round % 2 == 0, round % 3 == 0);
            assertEquals(first.size(), second.size());
            for (int i = 0; i < first.size(); i++) {
                assertEquals("seed " + SEED + ", round " + round + ", point " + i, 0,
                    java.util.Arrays.compare(first.get(i), second.get(i)));
            }
        }
    }
}
