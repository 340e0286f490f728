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
                    assertTrue(what, Math.abs(points.x(k)) <= lower[0] + ROUNDING && Math.abs(points.z(k)) <= lower[2] + ROUNDING);
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
        assertTrue(meet(RandomShapes.at(new ConvexBox(0.2, 0.1, 0.3), 1, 0.1, 2), RandomShapes.at(new ConvexBox(20, 0.05, 20), 0, -0.05, 0)));
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
        PlacedConvex tilted = RandomShapes.place(new ConvexBox(0.1, 0.1, 0.3), new double[] {0, 0, Math.sin(half), Math.cos(half)}, 0,
            0.1 * Math.sqrt(2), 0);
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

    @Test
    public void fourDistantPointsIncludingTheLowestAreChosen() {
        for (int i = 0; i < 40; i++) {
            double angle = 2 * Math.PI * i / 40;
            points.add(0, 1, 0, Math.cos(angle), 0, Math.sin(angle), i == 7 ? -1e-4 : 0);
        }
        assertEquals(4, points.choose(4));
        assertEquals(7, points.chosen(0));
        assertEquals(27, points.chosen(1));
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
