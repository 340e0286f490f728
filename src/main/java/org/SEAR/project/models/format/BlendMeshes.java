// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.math.Vector2f;
import com.jme3.math.Vector3f;
import com.jme3.scene.plugins.blender.BlenderContext;
import com.jme3.scene.plugins.blender.file.BlenderFileException;
import com.jme3.scene.plugins.blender.file.Structure;
import com.jme3.scene.plugins.blender.meshes.Face;
import com.jme3.scene.plugins.blender.meshes.MeshHelper;
import com.jme3.scene.plugins.blender.meshes.TemporalMesh;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads meshes of Blender files. jMonkeyEngine's reader fills in concave faces; here they are triangles before it
 * continues.
 */
final class BlendMeshes extends MeshHelper {
    private final PolygonSplitter splitter = new PolygonSplitter("", "");

    BlendMeshes(String version, BlenderContext context) {
        super(version, context);
    }

    @Override
    public TemporalMesh toTemporalMesh(Structure structure, BlenderContext context) throws BlenderFileException {
        TemporalMesh mesh = super.toTemporalMesh(structure, context);
        List<Vector3f> vertices = mesh == null ? List.of() : mesh.getVertices();
        float[] positions = new float[3 * vertices.size()];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = vertices.get(i / 3).get(i % 3);
        }
        List<Face> made = new ArrayList<>();
        boolean changed = false;
        for (Face face : mesh == null ? List.<Face>of() : mesh.getFaces()) {
            List<Face> triangles = face.vertexCount() > 3 ? triangles(face, positions, mesh) : List.of();
            changed |= !triangles.isEmpty();
            made.addAll(triangles.isEmpty() ? List.of(face) : triangles);
        }
        if (changed) {
            mesh.getFaces().clear();
            mesh.getFaces().addAll(made);
            mesh.rebuildIndexesMappings();
        }
        return mesh;
    }

    /** Returns the triangles of a concave face; an empty list for a convex one. */
    private List<Face> triangles(Face face, float[] positions, TemporalMesh mesh) throws BlenderFileException {
        List<Integer> corners = face.getIndexes().getAll();
        int[] ring = corners.stream().mapToInt(Integer::intValue).toArray();
        splitter.set(positions, ring, ring.length);
        if (splitter.convex()) {
            return List.of();
        }
        int[] split = splitter.split();
        if (splitter.work() > PolygonSplitter.MAX_WORK) {
            throw new BlenderFileException("a mesh has too many concave faces with many corners");
        }
        List<Face> triangles = new ArrayList<>();
        for (int i = 0; i < splitter.made(); i += 3) {
            int[] of = {split[i], split[i + 1], split[i + 2]};
            Map<String, List<Vector2f>> places = null;
            if (face.getUvSets() != null) {
                places = new HashMap<>();
                for (Map.Entry<String, List<Vector2f>> set : face.getUvSets().entrySet()) {
                    places.put(set.getKey(), picked(set.getValue(), of));
                }
            }
            triangles.add(new Face(picked(corners, of).toArray(new Integer[0]), face.isSmooth(),
                face.getMaterialNumber(), places,
                face.getVertexColors() == null ? null : picked(face.getVertexColors(), of), mesh));
        }
        return triangles;
    }

    private static <T> List<T> picked(List<T> all, int[] numbers) {
        List<T> picked = new ArrayList<>();
        for (int number : numbers) {
            if (number < all.size()) {
                picked.add(all.get(number));
            }
        }
        return picked;
    }
}
