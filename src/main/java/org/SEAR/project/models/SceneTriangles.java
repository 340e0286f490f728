// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import com.jme3.math.Matrix4f;
import com.jme3.math.Vector3f;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.VertexBuffer;
import com.jme3.scene.mesh.IndexBuffer;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.SEAR.files.FileLimits;
import org.SEAR.geometry.Triangles;
import org.SEAR.project.models.format.ModelLimits;

/** Triangles of a loaded scene, checked: valid vertex indices, finite coordinates within the limits. One use. */
final class SceneTriangles {
    private final String file;
    private final List<Geometry> solids = new ArrayList<>();
    private int nodes;
    private float[] positions;
    private int[] indices;
    private int vertexCount;
    private int indexCount;

    private SceneTriangles(String file) {
        this.file = file;
    }

    /**
     * Returns all triangles with the transforms of their nodes applied.
     *
     * @param file name of the model's file in errors
     * @throws IOException that names the mesh, the value and the limit
     */
    static Triangles of(Spatial scene, String file) throws IOException {
        return new SceneTriangles(file).collect(scene);
    }

    /**
     * Returns the geometries of the triangles, in their order.
     *
     * @param file name of the model's file in errors
     */
    static List<Geometry> solids(Spatial scene, String file) throws IOException {
        SceneTriangles triangles = new SceneTriangles(file);
        triangles.find(scene);
        triangles.solids.forEach(Geometry::computeWorldMatrix);
        return triangles.solids;
    }

    private Triangles collect(Spatial scene) throws IOException {
        find(scene);
        long vertices = 0;
        long triangles = 0;
        for (Geometry solid : solids) {
            vertices += solid.getMesh().getVertexCount();
            triangles += solid.getMesh().getTriangleCount();
        }
        FileLimits.range(file, "the number of vertices", vertices, 0, ModelLimits.MAX_TRIANGLES);
        FileLimits.range(file, "the number of triangles", triangles, 0, ModelLimits.MAX_TRIANGLES);
        positions = new float[(int) vertices * 3];
        indices = new int[(int) triangles * 3];
        for (Geometry solid : solids) {
            try {
                addTriangles(solid);
                addVertices(solid);
            } catch (RuntimeException e) {    // jMonkeyEngine's meshes throw all kinds of them
                throw FileLimits.wrong(file, "the mesh of " + name(solid), "damaged",
                    "vertices with positions, and triangles of them", e);
            }
        }
        return new Triangles(positions, indices);
    }

    private void find(Spatial scene) throws IOException {
        Deque<Spatial> waiting = new ArrayDeque<>();
        waiting.add(scene);
        while (!waiting.isEmpty()) {
            Spatial next = waiting.removeLast();
            FileLimits.range(file, "the number of nodes", ++nodes, 0, ModelLimits.MAX_NODES);
            if (next.getLocalCullHint() == CullHint.Always) {
                continue;       // hidden in the window, with all in it
            }
            if (next instanceof Node) {
                List<Spatial> children = ((Node) next).getChildren();
                for (int i = children.size() - 1; i >= 0; i--) {
                    waiting.addLast(children.get(i));
                }
            } else if (isSolid((Geometry) next)) {
                solids.add((Geometry) next);
            }
        }
    }

    private boolean isSolid(Geometry geometry) throws IOException {
        Mesh mesh = geometry.getMesh();
        if (mesh == null) {
            throw FileLimits.wrong(file, "the mesh of " + name(geometry), "missing", "a mesh");
        }
        switch (mesh.getMode()) {
            case Triangles:
            case TriangleStrip:
            case TriangleFan:
                return mesh.getBuffer(VertexBuffer.Type.Position) != null && mesh.getTriangleCount() > 0;
            default:
                return false;
        }
    }

    private static String name(Geometry geometry) {
        return "\"" + geometry.getName() + "\"";
    }

    private void addTriangles(Geometry solid) throws IOException {
        Mesh mesh = solid.getMesh();
        IndexBuffer source = mesh.getIndicesAsList();
        int count = mesh.getTriangleCount() * 3;
        if (source.size() < count) {
            throw FileLimits.wrong(file, "the number of indices of " + name(solid), source.size(), "at least " + count);
        }
        for (int i = 0; i < count; i++) {
            int index = source.get(i);
            if (index < 0 || index >= mesh.getVertexCount()) {
                throw FileLimits.wrong(file, "an index of " + name(solid), index,
                    "0 to " + (mesh.getVertexCount() - 1));
            }
            indices[indexCount++] = vertexCount + index;
        }
    }

    private void addVertices(Geometry solid) throws IOException {
        VertexBuffer buffer = solid.getMesh().getBuffer(VertexBuffer.Type.Position);
        int count = solid.getMesh().getVertexCount();
        if (buffer.getNumComponents() != 3 || buffer.getNumElements() < count) {
            throw FileLimits.wrong(file, "the positions of " + name(solid), buffer.getNumElements() + " x "
                + buffer.getNumComponents(), count + " of 3 numbers each");
        }
        Matrix4f place = place(solid);
        Vector3f point = new Vector3f();
        for (int i = 0; i < count; i++) {
            for (int axis = 0; axis < 3; axis++) {
                point.set(axis, ((Number) buffer.getElementComponent(i, axis)).floatValue());
            }
            place.mult(point, point);
            for (int axis = 0; axis < 3; axis++) {
                positions[(vertexCount + i) * 3 + axis] = checked(solid, i, point.get(axis));
            }
        }
        vertexCount += count;
    }

    private static Matrix4f place(Geometry solid) {
        solid.computeWorldMatrix();
        return solid.getWorldMatrix();
    }

    private float checked(Geometry solid, int vertex, float value) throws IOException {
        if (!(Math.abs(value) <= ModelLimits.MAX_COORDINATE)) {
            throw FileLimits.wrong(file, "a coordinate of vertex " + vertex + " of " + name(solid), value,
                "a finite number up to " + (int) ModelLimits.MAX_COORDINATE + " m from the model's origin");
        }
        return value;
    }
}
