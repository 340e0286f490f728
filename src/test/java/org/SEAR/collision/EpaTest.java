// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Depths of overlapping sets compared with closed forms and brute force. */
public class EpaTest {
    /** Tolerance of depths between flat faces, metres. */
    private static final double FLAT = 2e-6;
    /** Tolerance for curved surfaces of sets of 1 m, whose polytope runs out of faces, metres. */
    private static final double CURVED = 2e-3;

    private final RandomShapes shapes = new RandomShapes();
    private final GjkDistance gjk = new GjkDistance();

    @Test
    public void boxesSeparateAlongTheAxisOfLeastOverlap() {
        for (int i = 0; i < 500; i++) {
            double[] a = {shapes.size(), shapes.size(), shapes.size()};
            double[] b = {shapes.size(), shapes.size(), shapes.size()};
            double[] to = new double[3];
            double least = Double.POSITIVE_INFINITY;
            for (int axis = 0; axis < 3; axis++) {
                to[axis] = (2 * shapes.random.nextDouble() - 1) * (a[axis] + b[axis]);
                least = Math.min(least, a[axis] + b[axis] - Math.abs(to[axis]));
            }
            assertTrue(what(i), gjk.measure(RandomShapes.at(new ConvexBox(a[0], a[1], a[2]), to[0], to[1], to[2]),
                RandomShapes.at(new ConvexBox(b[0], b[1], b[2]), 0, 0, 0), 0));
            assertEquals(what(i), -least, gjk.distance, FLAT);
        }
    }

    @Test
    public void uprightCylindersSeparateUpwardsOrSideways() {
        for (int i = 0; i < 200; i++) {
            double a = shapes.size();
            double b = shapes.size();
            double x = (0.05 + 0.9 * shapes.random.nextDouble()) * (a + b);
            double y = shapes.random.nextDouble() * 1.9 - 0.95;
            assertTrue(what(i), gjk.measure(RandomShapes.at(ConvexRound.cylinder(a, 0.5), x, y, 0),
                RandomShapes.at(ConvexRound.cylinder(b, 0.5), 0, 0, 0), 0));
            assertEquals(what(i), -Math.min(1 - Math.abs(y), a + b - x), gjk.distance, CURVED);
        }
    }

    @Test
    public void ballsSeparateAlongTheLineOfTheirCentres() {
        for (int i = 0; i < 200; i++) {
            double[] n = shapes.direction(3);
            double radius = shapes.size();
            double apart = (0.3 + 0.65 * shapes.random.nextDouble()) * (radius + 0.5);
            assertTrue(what(i), gjk.measure(RandomShapes.ball(apart * n[0], apart * n[1], apart * n[2], radius),
                RandomShapes.ball(0, 0, 0, 0.5), 0));
            assertEquals(what(i), apart - radius - 0.5, gjk.distance, 2 * CURVED);
        }
    }

    @Test
    public void spheresSeparateAlongTheLineOfTheirCentres() {
        for (int i = 0; i < 200; i++) {
            double[] n = shapes.direction(3);
            double radius = shapes.size();
            double apart = (0.3 + 0.65 * shapes.random.nextDouble()) * (radius + 0.5);
            assertTrue(what(i), gjk.measure(RandomShapes.at(new ConvexEllipsoid(radius, radius, radius), apart * n[0],
                apart * n[1], apart * n[2]), RandomShapes.at(new ConvexEllipsoid(0.5, 0.5, 0.5), 0, 0, 0), 0));
            assertEquals(what(i), apart - radius - 0.5, gjk.distance, 2 * CURVED);
        }
    }

    /** Depth of a typical contact, up to 0.1 mm, where the polytope is finished immediately. */
    @Test
    public void aSphereThatTouchesABoxIsAsDeepAsItsLowestPoint() {
        for (int i = 0; i < 200; i++) {
            double radius = shapes.size();
            double depth = 1e-4 * shapes.random.nextDouble();
            assertTrue(what(i), gjk.measure(
                RandomShapes.at(new ConvexEllipsoid(radius, radius, radius), 0.3, 1 + radius - depth, -0.2),
                RandomShapes.at(new ConvexBox(1, 1, 1), 0, 0, 0), 0));
            assertEquals(what(i), -depth, gjk.distance, FLAT);
            assertEquals(what(i), 1, gjk.ny, 1e-4);
        }
    }

    /**
     * No direction separates the sets over a shorter distance, and the separation along the normal equals the depth.
     */
    @Test
    public void noDirectionSeparatesThemOverAShorterDistance() {
        int deep = 0;
        for (int i = 0; i < 500; i++) {
            PlacedConvex first = shapes.place(shapes.shape(), 0.7);
            PlacedConvex second = shapes.place(shapes.shape(), 0.7);
            if (gjk.measure(first, second, 0) && gjk.distance < -1e-5) {
                deep++;
                assertEquals(what(i), gjk.distance, RandomShapes.separation(first, second, gjk.nx, gjk.ny, gjk.nz),
                    2 * CURVED);
                for (int k = 0; k < 200; k++) {
                    double[] d = shapes.direction(3);
                    double other = RandomShapes.separation(first, second, d[0], d[1], d[2]);
                    assertTrue(what(i) + ": depth " + -gjk.distance + ", but " + -other + " is enough",
                        other <= gjk.distance + 2 * CURVED);
                }
            }
        }
        assertTrue(deep + " of 500 overlap", deep > 100);
    }

    private static String what(int pair) {
        return "seed " + RandomShapes.SEED + ", pair " + pair;
    }
}
