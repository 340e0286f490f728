// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import com.bulletphysics.collision.shapes.BvhTriangleMeshShape;
import com.bulletphysics.collision.shapes.TriangleIndexVertexArray;
import com.bulletphysics.util.ObjectArrayList;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.Triangles;

/** Collision shapes of triangle meshes. */
final class MeshShapes {
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));
    private static final int VERTEX_BYTES = 3 * Float.BYTES;
    private static final int TRIANGLE_BYTES = 3 * Integer.BYTES;

    private MeshShapes() {
    }

    /** Builds the search tree of a mesh. */
    static BvhTriangleMeshShape fixed(Triangles mesh, double sx, double sy, double sz) {
        double[] scale = {sx, sy, sz};
        ByteBuffer vertices = ByteBuffer.allocateDirect(mesh.vertices.length * Float.BYTES)
            .order(ByteOrder.nativeOrder());
        for (int i = 0; i < mesh.vertices.length; i++) {
            vertices.putFloat((float) (mesh.vertices[i] * scale[i % 3]));
        }
        ByteBuffer indices = ByteBuffer.allocateDirect(mesh.indices.length * Integer.BYTES)
            .order(ByteOrder.nativeOrder());
        for (int index : mesh.indices) {
            indices.putInt(index);
        }
        vertices.rewind();
        indices.rewind();
        TriangleIndexVertexArray array = new TriangleIndexVertexArray(mesh.size(), indices, TRIANGLE_BYTES,
            mesh.vertices.length / 3, vertices, VERTEX_BYTES);
        return new BvhTriangleMeshShape(array, true);
    }

    /** Returns the outermost corners of the scaled mesh in directions spread evenly over the sphere, each once. */
    static ObjectArrayList<Vector3f> corners(Triangles mesh, double sx, double sy, double sz, int directions) {
        boolean[] taken = new boolean[mesh.vertices.length / 3];
        ObjectArrayList<Vector3f> corners = new ObjectArrayList<>();
        for (int i = 0; i < directions; i++) {
            double dy = 1 - 2 * (i + 0.5) / directions;
            double ring = Math.sqrt(1 - dy * dy);
            int corner = outermost(mesh, sx * ring * Math.cos(i * GOLDEN_ANGLE), sy * dy,
                sz * ring * Math.sin(i * GOLDEN_ANGLE));
            if (!taken[corner]) {
                taken[corner] = true;
                corners.add(new Vector3f((float) (mesh.vertices[corner * 3] * sx),
                    (float) (mesh.vertices[corner * 3 + 1] * sy),
                    (float) (mesh.vertices[corner * 3 + 2] * sz)));
            }
        }
        return corners;
    }

    /** Returns the vertex that is furthest in a direction of the unscaled mesh. */
    static int outermost(Triangles mesh, double dx, double dy, double dz) {
        int best = 0;
        double farthest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < mesh.vertices.length / 3; i++) {
            double along = mesh.vertices[i * 3] * dx + mesh.vertices[i * 3 + 1] * dy + mesh.vertices[i * 3 + 2] * dz;
            if (along > farthest) {
                farthest = along;
                best = i;
            }
        }
        return best;
    }
}
