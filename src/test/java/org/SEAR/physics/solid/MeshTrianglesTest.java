// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.bulletphysics.collision.shapes.TriangleCallback;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.Triangles;
import org.junit.Test;

/** The search finds the triangles of a box, in the order of the mesh. */
public class MeshTrianglesTest {
    private static final int SIZE = 400;

    @Test
    public void itVisitsAllTrianglesInReachInTheOrderOfTheMesh() {
        Random random = new Random(5);
        float[] vertices = new float[9 * SIZE];
        int[] indices = new int[3 * SIZE];
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = (i % 9 < 3 ? 0 : vertices[i - i % 9 + i % 3]) + (i % 9 < 3 ? 10 : 1) * random.nextFloat();
        }
        for (int i = 0; i < indices.length; i++) {
            indices[i] = i;
        }
        MeshTriangles search = new MeshTriangles(new Triangles(vertices, indices), new double[] {1, 2, 1});
        for (int round = 0; round < 50; round++) {
            Vector3f low = new Vector3f(8 * random.nextFloat(), 16 * random.nextFloat(), 8 * random.nextFloat());
            Vector3f high = new Vector3f(low.x + 2, low.y + 4, low.z + 2);
            List<Integer> found = new ArrayList<>();
            search.find(new TriangleCallback() {
                @Override
                public void processTriangle(Vector3f[] corners, int part, int index) {
                    assertEquals(2 * vertices[9 * index + 4], corners[1].y, 0);
                    found.add(index);
                }
            }, low, high);
            for (int i = 1; i < found.size(); i++) {
                assertTrue("order: " + found, found.get(i - 1) < found.get(i));
            }
            for (int i = 0; i < SIZE; i++) {
                assertTrue("triangle " + i, found.contains(i) || !reaches(vertices, i, low, high));
            }
        }
    }

    private static boolean reaches(float[] vertices, int triangle, Vector3f low, Vector3f high) {
        float[] lows = {low.x, low.y / 2, low.z};
        float[] highs = {high.x, high.y / 2, high.z};
        for (int axis = 0; axis < 3; axis++) {
            int at = 9 * triangle + axis;
            float least = Math.min(vertices[at], Math.min(vertices[at + 3], vertices[at + 6]));
            float most = Math.max(vertices[at], Math.max(vertices[at + 3], vertices[at + 6]));
            if (least > highs[axis] || most < lows[axis]) {
                return false;
            }
        }
        return true;
    }
}
