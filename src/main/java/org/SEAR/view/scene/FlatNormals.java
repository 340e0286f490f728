// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.math.Vector3f;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Spatial;
import com.jme3.scene.VertexBuffer;
import com.jme3.scene.VertexBuffer.Type;
import com.jme3.scene.mesh.IndexBuffer;
import com.jme3.util.BufferUtils;
import java.nio.FloatBuffer;

/**
 * Adds flat normals, which lighting requires, to models without normals. The camera renderer and the tab do the same.
 * Window thread only.
 */
final class FlatNormals {
    private FlatNormals() {
    }

    /** Adds normals to each triangle mesh of a model that has none. */
    static void add(Spatial model) {
        model.depthFirstTraversal(spatial -> {
            if (spatial instanceof Geometry && ((Geometry) spatial).getMesh() != null) {
                Mesh mesh = ((Geometry) spatial).getMesh();
                if (mesh.getMode() == Mesh.Mode.Triangles && mesh.getBuffer(Type.Normal) == null
                    && mesh.getBuffer(Type.Position) != null) {
                    ((Geometry) spatial).setMesh(flat(mesh));
                }
            }
        });
    }

    /** Returns a mesh with separate corners for each triangle. */
    private static Mesh flat(Mesh shared) {
        IndexBuffer indices = shared.getIndicesAsList();
        int corners = 3 * shared.getTriangleCount();
        Mesh flat = new Mesh();
        for (VertexBuffer.Type type : new VertexBuffer.Type[] {Type.Position, Type.TexCoord, Type.Color}) {
            VertexBuffer from = shared.getBuffer(type);
            if (from != null) {
                FloatBuffer to = BufferUtils.createFloatBuffer(corners * from.getNumComponents());
                for (int i = 0; i < corners; i++) {
                    for (int component = 0; component < from.getNumComponents(); component++) {
                        to.put(((Number) from.getElementComponent(indices.get(i), component)).floatValue());
                    }
                }
                flat.setBuffer(type, from.getNumComponents(), to);
            }
        }
        flat.setBuffer(Type.Normal, 3, normals(flat.getFloatBuffer(Type.Position), corners));
        flat.updateCounts();
        flat.updateBound();
        return flat;
    }

    private static FloatBuffer normals(FloatBuffer at, int corners) {
        FloatBuffer normals = BufferUtils.createFloatBuffer(3 * corners);
        Vector3f a = new Vector3f();
        Vector3f b = new Vector3f();
        Vector3f c = new Vector3f();
        for (int i = 0; i + 2 < corners; i += 3) {
            BufferUtils.populateFromBuffer(a, at, i);
            BufferUtils.populateFromBuffer(b, at, i + 1);
            BufferUtils.populateFromBuffer(c, at, i + 2);
            Vector3f normal = b.subtractLocal(a).cross(c.subtractLocal(a)).normalizeLocal();
            for (int corner = 0; corner < 3; corner++) {
                normals.put(normal.x).put(normal.y).put(normal.z);
            }
        }
        return normals;
    }
}
