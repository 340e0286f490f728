// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Contact points of faces that lie on each other. */
public class ManifoldClipperTest {
    private static final double ROUNDING = 1e-6;

    private final RandomShapes shapes = new RandomShapes();
    private final GjkDistance gjk = new GjkDistance();
    private final ManifoldClipper clipper = new ManifoldClipper();
    private final ContactPoints points = new ContactPoints();

    @Test
    public void theContactOfTwoBoxesLiesInsideBothFaces() {
        for (int i = 0; i < 500; i++) {
            double clearance = 0.004 * (shapes.random.nextDouble() - 0.5);
            double[] lower = {shapes.size(), shapes.size(), shapes.size()};
            double[] upper = {shapes.size(), shapes.size(), shapes.size()};
            double yaw = Math.PI * shapes.random.nextDouble();
            double x = (2 * shapes.random.nextDouble() - 1) * (lower[0] + upper[0]) * 0.6;
            double z = (2 * shapes.random.nextDouble() - 1) * (lower[2] + upper[2]) * 0.6;
            PlacedConvex a = RandomShapes.place(new ConvexBox(upper[0], upper[1], upper[2]),
                new double[] {0, Math.sin(yaw / 2), 0, Math.cos(yaw / 2)}, x, lower[1] + upper[1] + clearance, z);
            PlacedConvex b = RandomShapes.at(new ConvexBox(lower[0], lower[1], lower[2]), 0, 0, 0);
            if (meet(a, b) && gjk.ny > 0.999 && Math.abs(gjk.distance - clearance) < 1e-4) {
                String what = "seed " + RandomShapes.SEED + ", pair " + i;
                assertTrue(what, points.size() >= 1 && points.size() <= 4);
                for (int k = 0; k < points.size(); k++) {
                    assertEquals(what, clearance, points.height(k), ROUNDING);
                    assertEquals(what, lower[1], points.y(k), Math.abs(clearance) + ROUNDING);
                    assertTrue(what, Math.abs(points.x(k)) <= lower[0] + ROUNDING && Math.abs(points.z(k)) <= lower[2]
                        + ROUNDING);
                    double ux = points.x(k) - x;
                    double uz = points.z(k) - z;
                    assertTrue(what, Math.abs(Math.cos(yaw) * ux - Math.sin(yaw) * uz) <= upper[0] + ROUNDING);
                    assertTrue(what, Math.abs(Math.sin(yaw) * ux + Math.cos(yaw) * uz) <= upper[2] + ROUNDING);
                }
            }
        }
    }

    @Test
    public void aBoxThatRestsTouchesWithItsFourCorners() {
        assertTrue(meet(RandomShapes.at(new ConvexBox(0.2, 0.1, 0.3), 1, 0.1, 2),
            RandomShapes.at(new ConvexBox(20, 0.05, 20), 0, -0.05, 0)));
        assertEquals(4, points.size());
        double square = 0;
        for (int i = 0; i < 4; i++) {
            assertEquals(0.2, Math.abs(points.x(i) - 1), ROUNDING);
            assertEquals(0.3, Math.abs(points.z(i) - 2), ROUNDING);
            square += (points.x(i) - 1) * (points.z(i) - 2);
        }
        assertEquals("a corner is there twice", 0, square, ROUNDING);
    }

    @Test
    public void aBoxOnItsEdgeTouchesWithBothEndsOfTheEdge() {
        double half = Math.PI / 8;
        PlacedConvex tilted = RandomShapes.place(new ConvexBox(0.1, 0.1, 0.3),
            new double[] {0, 0, Math.sin(half), Math.cos(half)}, 0, 0.1 * Math.sqrt(2), 0);
        assertTrue(meet(tilted, RandomShapes.at(new ConvexBox(20, 0.05, 20), 0, -0.05, 0)));
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < points.size(); i++) {
            if (points.height(i) < 1e-4) {
                least = Math.min(least, points.z(i));
                most = Math.max(most, points.z(i));
            }
        }
        assertEquals(-0.3, least, 1e-3);
        assertEquals(0.3, most, 1e-3);
    }

    /**
     * Two cylinders of radius 0.1 m and 0.15 m along z, of half lengths 0.5 m and 0.4 m, the upper one moved by 0.3 m.
     */
    private void lay(double crossing, double tilt, double gap) {
        double[] along = {Math.sin(Math.PI / 4), 0, 0, Math.cos(Math.PI / 4)};
        double[] turn = {0, Math.sin(crossing / 2), 0, Math.cos(crossing / 2)};
        double[] lean = {Math.sin(tilt / 2), 0, 0, Math.cos(tilt / 2)};
        PlacedConvex upper = RandomShapes.place(ConvexRound.cylinder(0.1, 0.5), product(turn, product(lean, along)), 0,
            0.25 + gap, 0.3);
        PlacedConvex lower = RandomShapes.place(ConvexRound.cylinder(0.15, 0.4), along, 0, 0, 0);
        assertTrue(meet(upper, lower));
    }

    private static double[] product(double[] p, double[] q) {
        return new double[] {p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1], p[3] * q[1] - p[0] * q[2]
            + p[1] * q[3] + p[2] * q[0],
            p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3], p[3] * q[3] - p[0] * q[0] - p[1] * q[1]
                - p[2] * q[2]};
    }

    @Test
    public void parallelCylindersTouchAtBothEndsOfTheirCommonLine() {
        for (double gap : new double[] {0.001, 0, -0.001}) {
            lay(0, 0, gap);
            assertEquals(2, points.size());
            assertEquals(0.2, points.z(0) + points.z(1), ROUNDING);
            assertEquals(0.6, Math.abs(points.z(0) - points.z(1)), ROUNDING);
            for (int i = 0; i < 2; i++) {
                assertEquals(gap, points.height(i), ROUNDING);
                assertEquals(0.15, points.y(i), ROUNDING);
                assertEquals(1, points.ny(i), 1e-9);
            }
        }
    }

    @Test
    public void tiltedCylindersTouchWithTheGapOfEachEnd() {
        lay(0, 1e-3, 0.002);
        assertEquals(2, points.size());
        for (int i = 0; i < 2; i++) {
            assertEquals(0.002 - 1e-3 * (points.z(i) - 0.3), points.height(i), 1e-5);
        }
    }

    @Test
    public void cylindersThatCrossAtASmallAngleTouchWhereTheyCrossAndNearlyAtTheEnds() {
        double angle = 0.05;
        lay(angle, 0, 0);
        assertEquals(3, points.size());
        double last = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 3; i++) {
            double beside = Math.tan(angle) * (points.z(i) - 0.3);
            assertEquals(Math.hypot(0.25, beside) - 0.25, points.height(i), 2e-5);
            assertEquals(1, points.ny(i), 1e-9);
            last = points.height(i);
        }
        assertEquals("where they cross", 0, last, 1e-6);
    }

    @Test
    public void cylindersThatCrossTouchInOnePoint() {
        lay(Math.PI / 2, 0, 0);
        assertEquals(1, points.size());
    }

    @Test
    public void aCylinderOnABoxEdgeTouchesAtBothEnds() {
        double half = Math.PI / 8;
        PlacedConvex edge = RandomShapes.place(new ConvexBox(0.1, 0.1, 0.3),
            new double[] {0, 0, Math.sin(half), Math.cos(half)}, 0, 0, 0);
        PlacedConvex log = RandomShapes.place(ConvexRound.cylinder(0.2, 0.5), new double[] {Math.sin(Math.PI / 4), 0, 0,
            Math.cos(Math.PI / 4)}, 0, 0.2 + 0.1 * Math.sqrt(2), 0);
        assertTrue(meet(log, edge));
        assertEquals(2, points.size());
        assertEquals(0.3, Math.abs(points.z(0)), ROUNDING);
        assertEquals(0, points.z(0) + points.z(1), ROUNDING);
    }

    @Test
    public void parallelEdgesOfBoxesTouchAtBothEnds() {
        double[] turned = {0, 0, Math.sin(Math.PI / 8), Math.cos(Math.PI / 8)};
        double apart = 0.2 * Math.sqrt(2) + 1e-4;
        assertTrue(meet(RandomShapes.place(new ConvexBox(0.1, 0.1, 0.3), turned, 0, apart, 0.1),
            RandomShapes.place(new ConvexBox(0.1, 0.1, 0.3), turned, 0, 0, 0)));
        assertEquals(2, points.size());
        assertEquals(0.1, points.z(0) + points.z(1), 1e-4);
        assertEquals(0.5, Math.abs(points.z(0) - points.z(1)), 1e-4);
    }

    @Test
    public void aConeOnItsSideTouchesAtItsApexAndItsBase() {
        double lean = Math.atan2(0.1, 0.4);
        double angle = (Math.PI / 2 + lean) / 2;
        double high = 0.2 * Math.sin(lean);
        PlacedConvex cone = RandomShapes.place(ConvexRound.cone(0.1, 0.2),
            new double[] {Math.sin(angle), 0, 0, Math.cos(angle)}, 0, high, 0);
        assertTrue(meet(cone, RandomShapes.at(new ConvexBox(20, 0.05, 20), 0, -0.05, 0)));
        assertEquals(2, points.size());
        assertEquals(Math.hypot(0.1, 0.4), Math.abs(points.z(0) - points.z(1)), 1e-3);
    }

    @Test
    public void aDiscThatLiesFlatTouchesWithFourPointsOfItsRim() {
        assertTrue(meet(RandomShapes.at(ConvexRound.cylinder(0.2, 0.05), 1, 0.05, 2),
            RandomShapes.at(new ConvexBox(20, 0.05, 20), 0, -0.05, 0)));
        assertEquals(4, points.size());
        double x = 0;
        double z = 0;
        for (int i = 0; i < 4; i++) {
            assertEquals(0.2, Math.hypot(points.x(i) - 1, points.z(i) - 2), ROUNDING);
            x += points.x(i) - 1;
            z += points.z(i) - 2;
        }
        assertEquals(0, Math.hypot(x, z), ROUNDING);
    }

    private boolean meet(PlacedConvex a, PlacedConvex b) {
        points.clear();
        if (!gjk.measure(a, b, ManifoldClipper.BREAKING)) {
            return false;
        }
        b.feature(gjk.nx, gjk.ny, gjk.nz, clipper.ofB);
        a.feature(-gjk.nx, -gjk.ny, -gjk.nz, clipper.ofA);
        clipper.find(gjk, points);
        return true;
    }
}
