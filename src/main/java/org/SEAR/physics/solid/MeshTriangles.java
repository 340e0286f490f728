// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import com.bulletphysics.collision.shapes.BvhTriangleMeshShape;
import com.bulletphysics.collision.shapes.TriangleCallback;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.Triangles;

/** Triangle search in a mesh by jbullet's tree. Simulation thread. */
final class MeshTriangles extends SortedTriangles {
    private final BvhTriangleMeshShape tree;
    private final TriangleCallback collector = new TriangleCallback() {
        @Override
        public void processTriangle(Vector3f[] triangle, int part, int index) {
            collect(index);
        }
    };

    /** @param scale along x, y and z */
    MeshTriangles(Triangles mesh, double[] scale) {
        super(mesh, scale);
        tree = MeshShapes.fixed(mesh, scale[0], scale[1], scale[2]);
    }

    @Override
    void search(Vector3f low, Vector3f high) {
        tree.processAllTriangles(collector, low, high);
    }
}
