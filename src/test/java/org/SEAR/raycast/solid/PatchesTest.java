// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.SEAR.geometry.Triangles;
import org.SEAR.raycast.tree.Bvh;
import org.junit.Test;

/** Patches contain each triangle of a model once. */
public class PatchesTest {
    private int patches;
    private int corners;

    /** Returns a grid of cells with two triangles each, some of them missing. */
    private static Triangles net(int cells) {
        Random random = new Random(5);
        float[] vertices = new float[3 * (cells + 1) * (cells + 1)];
        for (int i = 0; i < vertices.length; i += 3) {
            vertices[i] = i / 3 / (cells + 1);
            vertices[i + 1] = random.nextFloat();
            vertices[i + 2] = i / 3 % (cells + 1);
        }
        int[] indices = new int[6 * cells * cells];
        int n = 0;
        for (int cell = 0; cell < cells * cells; cell++) {
            int a = cell / cells * (cells + 1) + cell % cells;
            for (int half = 0; half < 2; half++) {
                if (random.nextInt(10) > 0) {
                    indices[n++] = a;
                    indices[n++] = half == 0 ? a + 1 : a + cells + 2;
                    indices[n++] = half == 0 ? a + cells + 2 : a + cells + 1;
                }
            }
        }
        return new Triangles(vertices, Arrays.copyOf(indices, n));
    }

    /** Returns triangles that share nothing. */
    private static Triangles soup(int count) {
        int[] indices = new int[3 * count];
        Arrays.setAll(indices, i -> i);
        Random random = new Random(6);
        float[] vertices = new float[9 * count];
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = random.nextFloat();
        }
        return new Triangles(vertices, indices);
    }

    @Test
    public void eachTriangleIsInOnePatchWithItsCornersAndInsideOfItsBox() {
        for (Triangles triangles : new Triangles[] {net(30), soup(500), soup(1), soup(Patches.CORNERS / 3),
            soup(Patches.MOST)}) {
            Mesh mesh = Mesh.of(triangles);
            boolean[] found = new boolean[triangles.size()];
            patches = 0;
            look(mesh, 0, found);
            for (int i = 0; i < found.length; i++) {
                assertTrue("triangle " + i, found[i]);
            }
        }
        assertEquals("no triangles", 0, Mesh.of(soup(0)).patches.tree.size());
    }

    @Test
    public void cornersThatTrianglesShareAreHeldOnce() {
        Triangles net = net(30);
        look(Mesh.of(net), 0, new boolean[net.size()]);
        assertTrue(net.size() + " triangles in " + patches + " patches", net.size() > 12 * patches);
        assertTrue(corners + " corners of " + net.size() + " triangles", corners < 1.3 * net.size());
    }

    private void look(Mesh mesh, int node, boolean[] found) {
        Bvh tree = mesh.patches.tree;
        int n = tree.count(node);
        int patch = tree.link(node);
        if (n == 0) {
            look(mesh, patch, found);
            look(mesh, patch + 1, found);
            return;
        }
        int[] links = mesh.patches.links;
        patches++;
        corners += links[patch + Patches.COUNT];
        assertTrue(links[patch + Patches.COUNT] + " corners", links[patch + Patches.COUNT] <= Patches.CORNERS);
        assertTrue(n + " triangles", n <= Patches.MOST);
        for (int i = 0; i < n; i++) {
            int triangle = links[patch + Patches.TRIANGLE] + i;
            assertTrue("triangle " + triangle + " twice", !found[triangle]);
            found[triangle] = true;
            for (int corner = 0; corner < 3; corner++) {
                int number = links[patch + Patches.LINKS + i] >> 8 * corner & 255;
                assertTrue("corner " + number, number < links[patch + Patches.COUNT]);
                int at = links[patch + Patches.CORNER] + 3 * number;
                int was = 9 * triangle + 3 * corner;
                float[] point = Arrays.copyOfRange(mesh.patches.corners, at, at + 3);
                assertArrayEquals(Arrays.copyOfRange(mesh.corners, was, was + 3), point, 0);
                for (int k = 0; k < 3; k++) {
                    int side = node * Bvh.STRIDE + k;
                    assertTrue("outside", tree.data[side] <= point[k] && point[k] <= tree.data[side + 3]);
                }
            }
        }
    }
}
