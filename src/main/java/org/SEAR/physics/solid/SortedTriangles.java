// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import com.bulletphysics.collision.shapes.TriangleCallback;
import java.util.Arrays;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.Triangles;

/**
 * Search in a mesh by a tree. The found triangles are visited in the order of the mesh, so contacts do not depend on
 * the nodes of the tree. Simulation thread.
 */
abstract class SortedTriangles implements TriangleSearch {
    private final Triangles mesh;
    private final double[] scale;
    private final Vector3f[] corners = {new Vector3f(), new Vector3f(), new Vector3f()};
    private int[] found = new int[64];
    private int count;

    /** @param scale along x, y and z */
    SortedTriangles(Triangles mesh, double[] scale) {
        this.mesh = mesh;
        this.scale = scale;
    }

    /** Calls {@link #collect} for each triangle that may reach into the box. */
    abstract void search(Vector3f low, Vector3f high);

    @Override
    public final void find(TriangleCallback visitor, Vector3f low, Vector3f high) {
        count = 0;
        search(low, high);
        Arrays.sort(found, 0, count);
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < corners.length; k++) {
                int at = 3 * mesh.indices[3 * found[i] + k];
                corners[k].set((float) (mesh.vertices[at] * scale[0]), (float) (mesh.vertices[at + 1] * scale[1]),
                    (float) (mesh.vertices[at + 2] * scale[2]));
            }
            visitor.processTriangle(corners, 0, found[i]);
        }
    }

    /** @param index number of a triangle in the mesh */
    final void collect(int index) {
        if (count == found.length) {
            found = Arrays.copyOf(found, 2 * count);
        }
        found[count++] = index;
    }
}
