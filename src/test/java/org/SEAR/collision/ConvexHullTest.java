// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Hulls compared with brute force over all planes through three points, and with known volumes. */
public class ConvexHullTest {
    private final RandomShapes shapes = new RandomShapes();

    @Test
    public void theHullContainsAllItsPointsAndHasNoOtherCorners() {
        for (int i = 0; i < 60; i++) {
            double[] points = shapes.cloud(4 + shapes.random.nextInt(200));
            ConvexHull hull = ConvexHull.of(points);
            double[] far = new double[3];
            for (int k = 0; k < 100; k++) {
                double[] d = shapes.direction(3);
                double most = Double.NEGATIVE_INFINITY;
                for (int at = 0; at < points.length; at += 3) {
                    most = Math.max(most, d[0] * points[at] + d[1] * points[at + 1] + d[2] * points[at + 2]);
                }
                hull.support(d[0], d[1], d[2], far);
                double reach = d[0] * far[0] + d[1] * far[1] + d[2] * far[2];
                assertTrue(what(i) + ": a point lies " + (most - reach) + " outside",
                    most - reach <= ConvexHull.TOLERANCE);
                assertTrue(what(i) + ": a corner that is no point", reach <= most);
            }
        }
    }

    /** The hull touches every plane that has all points on one side. */
    @Test
    public void everyPlaneThatBruteForceFindsIsAFace() {
        for (int i = 0; i < 20; i++) {
            double[] points = shapes.cloud(12);
            ConvexHull hull = ConvexHull.of(points);
            int faces = 0;
            for (int a = 0; a < 12; a++) {
                for (int b = 0; b < 12; b++) {
                    for (int c = 0; c < b; c++) {
                        faces += a != b && a != c && isTouched(hull, points, a, b, c, what(i)) ? 1 : 0;
                    }
                }
            }
            assertTrue(what(i), faces >= 4);
        }
    }

    private static boolean isTouched(ConvexHull hull, double[] p, int a, int b, int c, String what) {
        double[] u = {p[3 * b] - p[3 * a], p[3 * b + 1] - p[3 * a + 1], p[3 * b + 2] - p[3 * a + 2]};
        double[] w = {p[3 * c] - p[3 * a], p[3 * c + 1] - p[3 * a + 1], p[3 * c + 2] - p[3 * a + 2]};
        double[] n = {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
        double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        double plane = n[0] * p[3 * a] + n[1] * p[3 * a + 1] + n[2] * p[3 * a + 2];
        for (int i = 0; i < p.length; i += 3) {
            if (n[0] * p[i] + n[1] * p[i + 1] + n[2] * p[i + 2] > plane + 1e-12) {
                return false;
            }
        }
        double[] far = new double[3];
        hull.support(n[0], n[1], n[2], far);
        assertEquals(what, plane / length, (n[0] * far[0] + n[1] * far[1] + n[2] * far[2]) / length,
            ConvexHull.TOLERANCE);
        return true;
    }

    @Test
    public void aBoxFullOfPointsHasTheBoxesVolumeAndMiddle() {
        double[] points = shapes.cloud(300);
        for (int i = 0; i < 8; i++) {
            points[3 * i] = (i & 1) == 0 ? -1 : 1;
            points[3 * i + 1] = (i & 2) == 0 ? -1 : 1;
            points[3 * i + 2] = (i & 4) == 0 ? -1 : 1;
        }
        ConvexHull hull = ConvexHull.of(points);
        assertEquals(what(0), 8, hull.volume(), 1e-3);
        assertArrayEquals(new double[3], hull.centre(), 1e-3);
    }

    @Test
    public void aTetrahedronHasASixthOfItsCube() {
        ConvexHull hull = ConvexHull.of(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
        assertEquals(1 / 6.0, hull.volume(), 1e-12);
        assertArrayEquals(new double[] {0.25, 0.25, 0.25}, hull.centre(), 1e-12);
    }

    @Test
    public void pointsInAPlaneGetTheThicknessOfCard() {
        ConvexHull hull = ConvexHull.of(new double[] {0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1});
        assertTrue(hull.volume() + " m^3 of 1 m^2", hull.volume() > 4e-4 && hull.volume() < 1.1e-3);
    }

    private static String what(int cloud) {
        return "seed " + RandomShapes.SEED + ", cloud " + cloud;
    }
}
