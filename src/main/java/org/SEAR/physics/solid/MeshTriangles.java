// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import com.bulletphysics.collision.shapes.BvhTriangleMeshShape;
import com.bulletphysics.collision.shapes.TriangleCallback;
import java.util.Arrays;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.Triangles;

/**
 * Triangle search in a mesh. jbullet's tree finds the triangles; they are visited in the order of the mesh, so contacts
 * do not depend on the nodes of the tree. Simulation thread.
 */
final class MeshTriangles implements TriangleSearch {
    private final Triangles mesh;
    private final double[] scale;
    private final BvhTriangleMeshShape tree;
    private final Vector3f[] corners = {new Vector3f(), new Vector3f(), new Vector3f()};
    private int[] found = new int[64];
    private int count;
    private final TriangleCallback collector = new TriangleCallback() {
        @Override
        public void processTriangle(Vector3f[] triangle, int part, int index) {
            collect(index);
        }
    };

    /** @param scale along x, y and z */
    MeshTriangles(Triangles mesh, double[] scale) {
        this.mesh = mesh;
        this.scale = scale;
        tree = MeshShapes.fixed(mesh, scale[0], scale[1], scale[2]);
    }

    @Override
    public void find(TriangleCallback visitor, Vector3f low, Vector3f high) {
        count = 0;
        tree.processAllTriangles(collector, low, high);
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

    private void collect(int index) {
        if (count == found.length) {
            found = Arrays.copyOf(found, 2 * count);
        }
        found[count++] = index;
    }
}
