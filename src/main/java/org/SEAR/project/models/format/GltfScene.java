// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.files.FileLimits;

/**
 * Surface of the scene of a glTF 2.0 file. Vertices are in the scene's frame: morph targets with their default weights,
 * then the skin, or the transforms of the node and its parents, which may shear. One use.
 */
final class GltfScene {
    private static final int TRIANGLES = 4;
    private static final int FAN = 6;
    /** Joints of a vertex: sets of four. */
    private static final int MAX_JOINT_SETS = 4;
    /** Most vertices of all morph targets with a weight. */
    private static final int MAX_MORPHED = 10 * ModelLimits.MAX_TRIANGLES;

    /** A mesh with one material. */
    static final class Part {
        final SolidMesh mesh;
        /** Index of the material; -1 for white. */
        final int material;
        /** Place of the mesh in the file. */
        final String name;

        private Part(SolidMesh mesh, int material, String name) {
            this.mesh = mesh;
            this.material = material;
            this.name = name;
        }
    }

    private final GltfJson json;
    private final GltfAccessors accessors;
    private final int[] parents;
    private final AffineMatrix[] transforms;
    private final List<Part> parts = new ArrayList<>();
    private long vertices;
    private long triangles;
    private long morphed;

    /** @param parents parent of each node, -1 for none */
    GltfScene(GltfJson json, GltfAccessors accessors, int[] parents) {
        this.json = json;
        this.accessors = accessors;
        this.parents = parents;
        transforms = new AffineMatrix[parents.length];
    }

    /** Returns the parts of the scene that the file names, otherwise of the first. */
    List<Part> parts() throws IOException {
        JsonArray scenes = json.list("scenes");
        int number = Math.max(0, json.optional(json.root, "", "scene", "scenes"));
        for (JsonElement node : json.list(json.object(scenes, "scenes", number), "scenes[" + number + "]", "nodes")) {
            add(node.getAsInt());
        }
        return parts;
    }

    private void add(int number) throws IOException {
        String what = "nodes[" + number + "]";
        JsonObject node = json.object(json.list("nodes"), "nodes", number);
        int mesh = json.optional(node, what, "mesh", "meshes");
        if (mesh >= 0) {
            addMesh(mesh, node, number);
        }
        for (JsonElement child : json.list(node, what, "children")) {
            add(child.getAsInt());
        }
    }

    /** Returns the transform of a node to the scene's frame. */
    private AffineMatrix transform(int number) throws IOException {
        if (transforms[number] == null) {
            AffineMatrix own = AffineMatrix.of(json, json.object(json.list("nodes"), "nodes", number), "nodes[" + number
                + "]");
            transforms[number] = parents[number] < 0 ? own : transform(parents[number]).times(own);
        }
        return transforms[number];
    }

    private void addMesh(int number, JsonObject node, int nodeNumber) throws IOException {
        String what = "meshes[" + number + "]";
        JsonObject mesh = json.object(json.list("meshes"), "meshes", number);
        double[] weights = json.numbers(node, "nodes[" + nodeNumber + "]", "weights", -1);
        weights = weights == null ? json.numbers(mesh, what, "weights", -1) : weights;
        int skin = json.optional(node, "nodes[" + nodeNumber + "]", "skin", "skins");
        JsonArray primitives = json.list(mesh, what, "primitives");
        for (int i = 0; i < primitives.size(); i++) {
            String place = what + ".primitives[" + i + "]";
            JsonObject primitive = json.object(primitives, what + ".primitives", i);
            int mode = (int) json.whole(primitive, place, "mode", TRIANGLES, 0, FAN);
            JsonObject attributes = json.object(primitive, place, "attributes");
            if (mode >= TRIANGLES && attributes.has("POSITION")) {
                SolidMesh made = mesh(primitive, attributes, place, mode, weights);
                JsonObject moving = skin >= 0 && attributes.has("JOINTS_0") ? attributes : null;
                move(made, moving, place, skin, nodeNumber);
                parts.add(new Part(made, json.optional(primitive, place, "material", "materials"), place));
                FileLimits.range(json.file, "the number of meshes of all nodes", parts.size(), 0,
                    ModelLimits.MAX_NODES - 1);
            }
        }
    }

    private SolidMesh mesh(JsonObject primitive, JsonObject attributes, String place, int mode,
        double[] weights) throws IOException {
        int position = json.reference(attributes, place + ".attributes", "POSITION", "accessors");
        int count = accessors.count(position);
        vertices += count;
        FileLimits.range(json.file, "the number of vertices", vertices, 0, ModelLimits.MAX_TRIANGLES);
        float[] positions = accessors.floats(position, place + ".attributes.POSITION", count, 3);
        SolidMesh mesh = new SolidMesh(positions, triangles(corners(primitive, place, count, mode), mode));
        mesh.normals = attribute(attributes, place, "NORMAL", count, 3);
        mesh.places = attribute(attributes, place, "TEXCOORD_0", count, 2);
        mesh.colors = opaque(attribute(attributes, place, "COLOR_0", count, 3, 4), count);
        JsonArray targets = json.list(primitive, place, "targets");
        if (weights != null && targets.size() > 0) {
            FileLimits.range(json.file, "the number of weights of the morph targets of " + place, weights.length,
                targets.size(), targets.size());
            for (int i = 0; i < weights.length; i++) {
                morph(mesh, json.object(targets, place + ".targets", i), place + ".targets[" + i + "]", weights[i],
                    count);
            }
        }
        return mesh;
    }

    private float[] attribute(JsonObject attributes, String place, String name, int count,
        int... components) throws IOException {
        int accessor = json.optional(attributes, place + ".attributes", name, "accessors");
        return accessor < 0 ? null : accessors.floats(accessor, place + ".attributes." + name, count, components);
    }

    /** Returns colours with alpha. */
    private static float[] opaque(float[] colors, int count) {
        if (colors == null || colors.length == 4 * count) {
            return colors;
        }
        float[] all = new float[4 * count];
        for (int i = 0; i < all.length; i++) {
            all[i] = i % 4 == 3 ? 1 : colors[i / 4 * 3 + i % 4];
        }
        return all;
    }

    private void morph(SolidMesh mesh, JsonObject target, String what, double weight, int count) throws IOException {
        if (weight == 0) {
            return;
        }
        morphed += count;
        FileLimits.range(json.file, "the number of vertices of all morph targets", morphed, 0, MAX_MORPHED);
        add(mesh.positions, target, what, "POSITION", weight, count);
        if (mesh.normals != null) {
            add(mesh.normals, target, what, "NORMAL", weight, count);
        }
    }

    private void add(float[] to, JsonObject target, String what, String name, double weight,
        int count) throws IOException {
        int accessor = json.optional(target, what, name, "accessors");
        if (accessor >= 0) {
            float[] by = accessors.floats(accessor, what + "." + name, count, 3);
            for (int i = 0; i < by.length; i++) {
                to[i] += weight * by[i];
            }
        }
    }

    /** Returns the vertices in their order, by the indices if there are any. */
    private int[] corners(JsonObject primitive, String place, int count, int mode) throws IOException {
        int indices = json.optional(primitive, place, "indices", "accessors");
        int corners = indices < 0 ? count : accessors.count(indices);
        triangles += mode == TRIANGLES ? corners / 3 : Math.max(0, corners - 2);
        FileLimits.range(json.file, "the number of triangles", triangles, 0, ModelLimits.MAX_TRIANGLES);
        if (indices >= 0) {
            return accessors.whole(indices, place + ".indices", corners, 1, count);
        }
        int[] all = new int[count];
        Arrays.setAll(all, i -> i);
        return all;
    }

    private static int[] triangles(int[] corners, int mode) {
        if (mode == TRIANGLES) {
            return corners.length % 3 == 0 ? corners : Arrays.copyOf(corners, corners.length / 3 * 3);
        }
        return mode == FAN ? SolidMesh.fan(corners, corners.length) : SolidMesh.strip(corners, corners.length);
    }

    /** Moves a mesh to the scene's frame. */
    private void move(SolidMesh mesh, JsonObject attributes, String place, int skin, int node) throws IOException {
        if (attributes != null) {
            skin(mesh, attributes, place, joints(skin));
            return;
        }
        mesh.move(transform(node));
    }

    private static void move(SolidMesh mesh, int at, AffineMatrix to) {
        to.point(mesh.positions, at);
        if (mesh.normals != null) {
            to.normal(mesh.normals, at);
        }
    }

    /** Returns the transform of each joint of a skin, from the mesh's frame to the scene's. */
    private AffineMatrix[] joints(int number) throws IOException {
        String what = "skins[" + number + "]";
        JsonObject skin = json.object(json.list("skins"), "skins", number);
        JsonArray nodes = json.list(skin, what, "joints");
        int inverse = json.optional(skin, what, "inverseBindMatrices", "accessors");
        String matrices = what + ".inverseBindMatrices";
        float[] bind = inverse < 0 ? null : accessors.floats(inverse, matrices, accessors.count(inverse), 16);
        FileLimits.range(json.file, "the number of " + matrices, bind == null ? nodes.size() : bind.length / 16,
            nodes.size(),
            Integer.MAX_VALUE);
        AffineMatrix[] joints = new AffineMatrix[nodes.size()];
        for (int i = 0; i < joints.length; i++) {
            AffineMatrix joint = transform(nodes.get(i).getAsInt());
            joints[i] = bind == null ? joint
                : joint.times(AffineMatrix.of(json.file, matrices + "[" + i + "]", bind, 16 * i));
        }
        return joints;
    }

    private void skin(SolidMesh mesh, JsonObject attributes, String place, AffineMatrix[] joints) throws IOException {
        int count = mesh.positions.length / 3;
        int sets = 0;
        while (attributes.has("JOINTS_" + sets)) {
            FileLimits.range(json.file, "the number of joints and weights of " + place, ++sets, 1, MAX_JOINT_SETS);
        }
        int[][] of = new int[sets][];
        float[][] weights = new float[sets][];
        for (int set = 0; set < sets; set++) {
            String name = place + ".attributes.JOINTS_" + set;
            of[set] = accessors.whole(json.reference(attributes, place + ".attributes", "JOINTS_" + set, "accessors"),
                name, count, 4, joints.length);
            weights[set] = accessors.floats(json.reference(attributes, place + ".attributes", "WEIGHTS_" + set,
                "accessors"),
                place + ".attributes.WEIGHTS_" + set, count, 4);
        }
        AffineMatrix[] used = new AffineMatrix[4 * sets];
        float[] shares = new float[4 * sets];
        for (int i = 0; i < count; i++) {
            double sum = 0;
            for (int k = 0; k < used.length; k++) {
                used[k] = joints[of[k / 4][4 * i + k % 4]];
                shares[k] = weights[k / 4][4 * i + k % 4];
                sum += shares[k];
            }
            for (int k = 0; k < shares.length; k++) {
                shares[k] = sum > 0 ? (float) (shares[k] / sum) : k == 0 ? 1 : 0;
            }
            move(mesh, 3 * i, AffineMatrix.blend(used, shares));
        }
    }
}
