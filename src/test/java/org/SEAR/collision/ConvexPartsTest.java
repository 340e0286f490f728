// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/** Parts of meshes with known volumes, and of meshes that enclose nothing. */
public class ConvexPartsTest {
    private static List<ConvexHull> parts(Meshes mesh) {
        return ConvexParts.of(mesh.points(), mesh.indices(), share -> { });
    }

    private static double volume(List<ConvexHull> parts) {
        return parts.stream().mapToDouble(ConvexHull::volume).sum();
    }

    private static void assertParts(int count, double volume, double tolerance, Meshes mesh) {
        List<ConvexHull> parts = parts(mesh);
        assertEquals("parts", count, parts.size());
        assertEquals("volume", volume, volume(parts), tolerance * volume);
    }

    @Test
    public void boxesAreTakenApartExactly() {
        assertParts(1, 1, 1e-6, new Meshes().box(0, 0, 0, 1, 1, 1));
        assertParts(2, 2, 1e-6, new Meshes().box(0, 0, 0, 1, 1, 1).box(3, 0, 0, 4, 1, 1));
        assertParts(2, 0.19, 1e-6, new Meshes().box(0, 0, 0, 1, 0.1, 1).box(0, 0.1, 0, 0.1, 1, 1));
    }

    private static Meshes channel() {
        return new Meshes().box(0, 0, 0, 1, 0.1, 1).box(0, 0.1, 0, 0.13, 1, 1).box(0.9, 0.1, 0, 1, 1, 1);
    }

    @Test
    public void soAreTurnedOnes() {
        assertParts(3, 0.307, 1e-6, channel());
        assertParts(3, 0.307, 1e-5, channel().rotated(0.5, 0.3));
    }

    @Test
    public void aConvexSolidIsOnePart() {
        assertEquals(1, parts(new Meshes().turned(60, new double[][] {{0, 0}, {0.3, 0}, {0.3, 1}, {0, 1}})).size());
        assertEquals(1, parts(new Meshes().turned(60, new double[][] {{0, 0}, {0.3, 0.4}, {0, 1}}).without(7)).size());
    }

    @Test
    public void roundHollowsStayOpen() {
        double torus = 2 * Math.PI * Math.PI * 0.3 * 0.05 * 0.05;
        assertEquals(torus, volume(parts(new Meshes().torus(0.3, 0.05, 48, 16))), 0.05 * torus);
        Meshes cup = new Meshes().turned(
            64, new double[][] {{0, 0}, {0.04, 0}, {0.04, 0.1}, {0.035, 0.1}, {0.035, 0.005}, {0, 0.005}});
        double volume = Math.PI * (0.04 * 0.04 * 0.1 - 0.035 * 0.035 * 0.095);
        assertEquals(volume, volume(parts(cup)), 0.15 * volume);
    }

    @Test
    public void anOpenBoxStaysOpen() {
        Meshes open = new Meshes().box(0, 0, 0, 1, 1, 1).without(6).without(6);
        assertTrue(volume(parts(open)) < 0.1);
    }

    @Test
    public void theSameMeshGivesTheSameParts() {
        List<ConvexHull> one = parts(new Meshes().torus(0.3, 0.1, 24, 12));
        List<ConvexHull> other = parts(new Meshes().torus(0.3, 0.1, 24, 12));
        assertEquals(one.size(), other.size());
        for (int i = 0; i < one.size(); i++) {
            assertArrayEquals(one.get(i).corners(), other.get(i).corners(), 0);
        }
    }

    /** Triangles at random, in planes, lines and points, some of them repeated; sizes from 1 um to 100 km. */
    @Test
    public void hostileMeshesGiveFewParts() {
        long seed = System.nanoTime();
        Random random = new Random(seed);
        for (int i = 0; i < 15; i++) {
            double[] size = new double[3];
            double scale = Math.pow(10, random.nextInt(12) - 6);
            for (int axis = 0; axis < 3; axis++) {
                size[axis] = random.nextInt(4) == 0 ? 0 : scale * Math.pow(10, -random.nextInt(4));
            }
            double[] points = new double[3 * (1 + random.nextInt(40))];
            for (int k = 0; k < points.length; k++) {
                points[k] = (float) (size[k % 3] * random.nextInt(5));
            }
            List<Double> shares = new ArrayList<>();
            int[] indices = random.ints(3 * (1 + random.nextInt(20)), 0, points.length / 3).toArray();
            List<ConvexHull> parts = ConvexParts.of(points, indices, shares::add);
            String what = "seed " + seed + ", mesh " + i;
            assertTrue(what + ": " + shares, shares.stream().allMatch(share -> share >= 0 && share < 1));
            assertTrue(what, parts.size() <= ConvexParts.MAX_PARTS && parts.size() > 0);
            assertTrue(what, Double.isFinite(volume(parts)));
        }
    }
}
