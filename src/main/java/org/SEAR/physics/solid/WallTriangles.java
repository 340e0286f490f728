// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import javax.vecmath.Vector3f;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Triangles;
import org.SEAR.raycast.solid.Mesh;
import org.SEAR.raycast.tree.BoxTraversal;

/**
 * Triangle search in walls by the tree of their beams: walls of a large picture have many triangles, and a second tree
 * would double the time to load them. Simulation thread.
 */
final class WallTriangles extends SortedTriangles {
    private final Mesh mesh;
    private final double[] scale;
    private final BoxTraversal traversal = new BoxTraversal();
    private final Aabb box = new Aabb();

    /** @param scale along x, y and z, positive */
    WallTriangles(Triangles triangles, double[] scale) {
        super(triangles, scale);
        this.scale = scale;
        mesh = Mesh.of(triangles);
    }

    @Override
    void search(Vector3f low, Vector3f high) {
        box.set(0, low.x / scale[0], high.x / scale[0]);
        box.set(1, low.y / scale[1], high.y / scale[1]);
        box.set(2, low.z / scale[2], high.z / scale[2]);
        traversal.start(mesh.tree, box);
        for (int leaf = traversal.next(); leaf >= 0; leaf = traversal.next()) {
            int first = mesh.tree.link(leaf);
            for (int i = first; i < first + mesh.tree.count(leaf); i++) {
                collect(mesh.order[i]);
            }
        }
    }
}
