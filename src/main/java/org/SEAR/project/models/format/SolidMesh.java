// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.asset.AssetManager;
import com.jme3.material.Material;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.VertexBuffer.Type;
import com.jme3.util.BufferUtils;

/** Vertices and triangles of one material, in the model's frame. */
final class SolidMesh {
    private static final float SHININESS = 64;

    /** x, y and z of each vertex, m. */
    final float[] positions;
    /** Three vertices of each triangle, anticlockwise when seen from outside. */
    final int[] indices;
    /** x, y and z of each vertex's unit normal; null if the file has none. */
    float[] normals;
    /** Texture coordinates u and v of each vertex; null if the file has none. */
    float[] places;
    /** Red, green, blue and alpha of each vertex, 0 to 1; null if the file has none. */
    float[] colors;

    SolidMesh(float[] positions, int[] indices) {
        this.positions = positions;
        this.indices = indices;
    }

    /** Returns a mesh of jMonkeyEngine with these data. */
    Mesh mesh() {
        Mesh mesh = new Mesh();
        set(mesh, Type.Position, 3, positions);
        set(mesh, Type.Normal, 3, normals);
        set(mesh, Type.TexCoord, 2, places);
        set(mesh, Type.Color, 4, colors);
        mesh.setBuffer(Type.Index, 3, BufferUtils.createIntBuffer(indices));
        mesh.setStatic();
        mesh.updateBound();
        return mesh;
    }

    /** Returns the triangles of a strip, each with the orientation of the first. */
    static int[] strip(int[] corners, int count) {
        int[] all = new int[3 * Math.max(0, count - 2)];
        for (int i = 0; i < all.length / 3; i++) {
            all[3 * i] = corners[i];
            all[3 * i + 1] = corners[i + 1 + i % 2];
            all[3 * i + 2] = corners[i + 2 - i % 2];
        }
        return all;
    }

    /** Returns the triangles of a fan around its first corner. */
    static int[] fan(int[] corners, int count) {
        int[] all = new int[3 * Math.max(0, count - 2)];
        for (int i = 0; i < all.length / 3; i++) {
            all[3 * i] = corners[0];
            all[3 * i + 1] = corners[i + 1];
            all[3 * i + 2] = corners[i + 2];
        }
        return all;
    }

    private static void set(Mesh mesh, Type type, int components, float[] values) {
        if (values != null) {
            mesh.setBuffer(type, components, BufferUtils.createFloatBuffer(values));
        }
    }

    /** Returns a mesh with numbers of its own. */
    SolidMesh copy() {
        SolidMesh copy = new SolidMesh(positions.clone(), indices.clone());
        copy.normals = normals == null ? null : normals.clone();
        copy.places = places == null ? null : places.clone();
        copy.colors = colors == null ? null : colors.clone();
        return copy;
    }

    /** Moves the mesh to another frame. */
    void move(AffineMatrix to) {
        for (int i = 0; i < positions.length; i += 3) {
            to.point(positions, i);
            if (normals != null) {
                to.normal(normals, i);
            }
        }
        if (to.mirrors()) {
            for (int i = 0; i < indices.length; i += 3) {
                int second = indices[i + 1];
                indices[i + 1] = indices[i + 2];
                indices[i + 2] = second;
            }
        }
    }

    /** Returns the material of a surface without one. */
    static Material white(AssetManager manager) {
        Material white = new Material(manager, "Common/MatDefs/Light/Lighting.j3md");
        white.setFloat("Shininess", SHININESS);
        return white;
    }

    /** Returns a mesh with its material. */
    static Geometry geometry(String name, Mesh mesh, Material material) {
        Geometry geometry = new Geometry(name, mesh);
        geometry.setMaterial(material);
        return geometry;
    }
}
