// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Distances compared with closed forms, witness points and a dense search. */
public class GjkDistanceTest {
    private static final double FAR = 100;
    private static final double EXACT = 2e-7;

    private final RandomShapes shapes = new RandomShapes();
    private final GjkDistance gjk = new GjkDistance();

    @Test
    public void boxesSideBySideAreAsFarApartAsTheirFacesEdgesOrCorners() {
        for (int i = 0; i < 500; i++) {
            double[] a = {shapes.size(), shapes.size(), shapes.size()};
            double[] b = {shapes.size(), shapes.size(), shapes.size()};
            double[] to = shapes.random.doubles(3, -4, 4).toArray();
            double square = 0;
            for (int axis = 0; axis < 3; axis++) {
                double gap = Math.max(0, Math.abs(to[axis]) - a[axis] - b[axis]);
                square += gap * gap;
            }
            if (square > 0) {
                assertTrue(gjk.measure(RandomShapes.at(new ConvexBox(a[0], a[1], a[2]), 0, 0, 0),
                    RandomShapes.at(new ConvexBox(b[0], b[1], b[2]), to[0], to[1], to[2]), FAR));
                assertEquals(what(i), Math.sqrt(square), gjk.distance, EXACT);
            }
        }
    }

    @Test
    public void ballsAreAsFarApartAsTheirCentresLessTheirRadii() {
        for (int i = 0; i < 200; i++) {
            double[] n = shapes.direction(3);
            double gap = shapes.size();
            double radius = shapes.size();
            double apart = 0.5 + radius + gap;
            assertTrue(gjk.measure(RandomShapes.ball(apart * n[0], apart * n[1], apart * n[2], radius),
                RandomShapes.ball(0, 0, 0, 0.5), FAR));
            assertEquals(what(i), gap, gjk.distance, EXACT);
            assertEquals(what(i), 1, gjk.nx * n[0] + gjk.ny * n[1] + gjk.nz * n[2], 1e-6);
            assertEquals(what(i), 0.5 * n[0], gjk.onB[0], 1e-3);
        }
    }

    /** A plane that separates both sets by the distance and a point of each set at that distance together prove it. */
    @Test
    public void everyDistanceHasWitnessPoints() {
        int apart = 0;
        for (int i = 0; i < 2000; i++) {
            PlacedConvex first = shapes.place(shapes.shape(), 2);
            PlacedConvex second = shapes.place(shapes.shape(), 2);
            if (gjk.measure(first, second, FAR) && gjk.distance > 0) {
                apart++;
                assertEquals(what(i), gjk.distance,
                    RandomShapes.separation(first, second, gjk.nx, gjk.ny, gjk.nz), 2 * EXACT);
                assertInside(what(i), second, gjk.onB);
                assertInside(what(i), first, new double[] {gjk.onB[0] + gjk.distance * gjk.nx, gjk.onB[1]
                    + gjk.distance * gjk.ny, gjk.onB[2] + gjk.distance * gjk.nz});
            }
        }
        assertTrue(apart + " of 2000 were apart", apart > 500);
    }

    /** The result of the face test equals the result of the search. */
    @Test
    public void aFaceUnderTheOthersSupportPointIsTheResult() {
        int ofFirst = 0;
        int ofSecond = 0;
        GjkDistance byFace = new GjkDistance();
        ContactFeature face = new ContactFeature();
        for (int i = 0; i < 3000; i++) {
            PlacedConvex first = shapes.place(shapes.shape(), 2);
            PlacedConvex second = shapes.place(shapes.shape(), 2);
            if (!gjk.measure(first, second, FAR) || gjk.distance <= EXACT) {
                continue;
            }
            second.feature(gjk.nx, gjk.ny, gjk.nz, face);
            if (byFace.byFace(face, true, first, 0)) {
                ofSecond++;
                assertSame(what(i), byFace);
            }
            first.feature(-gjk.nx, -gjk.ny, -gjk.nz, face);
            if (byFace.byFace(face, false, second, 0)) {
                ofFirst++;
                assertSame(what(i), byFace);
            }
        }
        assertTrue("faces that were answers: " + ofFirst + " and " + ofSecond, ofFirst > 100 && ofSecond > 100);
    }

    private void assertSame(String what, GjkDistance other) {
        assertEquals(what, gjk.distance, other.distance, 2 * EXACT);
        assertEquals(what, 1, gjk.nx * other.nx + gjk.ny * other.ny + gjk.nz * other.nz, 1e-6);
        for (int axis = 0; axis < 3; axis++) {
            assertEquals(what, gjk.onB[axis], other.onB[axis], 1e-3);
        }
    }

    @Test
    public void aFaceBesideTheOthersSupportPointIsNoResult() {
        PlacedConvex cube = RandomShapes.at(new ConvexBox(0.5, 0.5, 0.5), 0, 0, 0);
        PlacedConvex beside = RandomShapes.at(new ConvexBox(0.1, 0.1, 0.1), 0.7, 0.8, 0);
        ContactFeature top = new ContactFeature();
        cube.feature(0, 1, 0, top);
        assertFalse(gjk.byFace(top, true, beside, 0));
        assertTrue(gjk.byFace(top, true, RandomShapes.at(new ConvexBox(0.1, 0.1, 0.1), 0.2, 0.8, 0), 0));
        assertFalse("deeper than said",
            gjk.byFace(top, true, RandomShapes.at(new ConvexBox(0.1, 0.1, 0.1), 0.2, 0.58, 0), 0.01));
        assertTrue(gjk.byFace(top, true, RandomShapes.at(new ConvexBox(0.1, 0.1, 0.1), 0.2, 0.58, 0), 0.03));
    }

    @Test
    public void aDenseSearchFindsNoGreaterSeparation() {
        for (int i = 0; i < 40; i++) {
            PlacedConvex first = shapes.place(shapes.shape(), 2);
            PlacedConvex second = shapes.place(shapes.shape(), 2);
            if (gjk.measure(first, second, FAR) && gjk.distance > 0) {
                double found = shapes.densest(first, second);
                assertTrue(what(i) + ": " + gjk.distance + ", but a plane parts them by " + found,
                    found <= gjk.distance + EXACT);
                assertEquals(what(i), found, gjk.distance, 1e-3);
            }
        }
    }

    @Test
    public void distancesBeyondTheReachAreNotMeasured() {
        ConvexBox box = new ConvexBox(0.5, 0.5, 0.5);
        assertFalse(gjk.measure(RandomShapes.at(box, 0, 0, 0), RandomShapes.at(box, 1.1, 0, 0), 0.09));
        assertTrue(gjk.measure(RandomShapes.at(box, 0, 0, 0), RandomShapes.at(box, 1.1, 0, 0), 0.11));
    }

    private void assertInside(String what, Convex set, double[] point) {
        double[] far = new double[3];
        for (int k = 0; k < 50; k++) {
            double[] d = shapes.direction(3);
            set.support(d[0], d[1], d[2], far);
            double over = d[0] * (point[0] - far[0]) + d[1] * (point[1] - far[1]) + d[2] * (point[2] - far[2]);
            assertTrue(what + ": a point lies " + over + " outside", over < 1e-6);
        }
    }

    private static String what(int pair) {
        return "seed " + RandomShapes.SEED + ", pair " + pair;
    }
}
