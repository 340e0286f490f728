// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.SEAR.files.FileLimits;

/**
 * Checks the JSON of a glTF 2.0 file before its data are read: nodes form a tree, each reference is valid, and each
 * accessor lies in its view, each view in its buffer, each buffer in the file. One use.
 */
final class GltfCheck {
    static final Map<String, Integer> COMPONENTS = Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4, "MAT2", 4,
        "MAT3", 9, "MAT4", 16);
    static final Map<Integer, Integer> BYTES = Map.of(5120, 1, 5121, 1, 5122, 2, 5123, 2, 5125, 4, 5126, 4);
    /** Component types of indices: unsigned numbers. */
    private static final Set<Integer> UNSIGNED = new TreeSet<>(Set.of(5121, 5123, 5125));
    private static final Set<String> EXTENSIONS = new TreeSet<>(Set.of("KHR_materials_pbrSpecularGlossiness",
        "KHR_lights_punctual", "KHR_materials_unlit", "KHR_texture_transform", "KHR_mesh_quantization"));
    private static final long MAX_BYTES = 1L << 31;

    /** Sizes of the buffers. */
    interface Files {
        /**
         * Returns the number of bytes of a buffer's data.
         *
         * @param uri text of the file; null for the binary chunk
         * @throws IOException if there is no such file
         */
        long size(int buffer, String uri) throws IOException;
    }

    private final GltfJson json;
    private final String file;
    private final Files files;
    /** Parent of each node plus 1; 0 for none. */
    private int[] parent;

    GltfCheck(GltfJson json, Files files) {
        this.json = json;
        this.file = json.file;
        this.files = files;
    }

    /** @return parent of each node, -1 for none */
    int[] check() throws IOException {
        checkVersion();
        checkExtensions();
        checkNodes();
        checkScenes();
        checkBuffers();
        checkAccessors();
        checkMeshes();
        checkSkins();
        checkPictures();
        checkAnimations();
        int[] parents = parent.clone();
        for (int i = 0; i < parents.length; i++) {
            parents[i]--;
        }
        return parents;
    }

    private void checkVersion() throws IOException {
        JsonObject asset = json.object(json.root, "", "asset");
        String version = json.text(asset, "asset", "version", "missing");
        String least = json.text(asset, "asset", "minVersion", "2.0");
        if (!version.startsWith("2.") || !least.equals("2.0")) {
            throw FileLimits.wrong(file, "asset.version", version
                + (least.equals("2.0") ? "" : ", and at least " + least), "2.0");
        }
    }

    /**
     * Rejects required extensions that the reader does not support: without them the shape is wrong, for example all
     * compressed vertices lie in one point.
     */
    private void checkExtensions() throws IOException {
        for (JsonElement needed : json.list("extensionsRequired")) {
            String name = needed.isJsonPrimitive() ? needed.getAsString() : needed.toString();
            if (!EXTENSIONS.contains(name)) {
                throw FileLimits.wrong(file, "a required extension", name, "one of " + String.join(", ", EXTENSIONS)
                    + ": export it without compression and other extensions");
            }
        }
    }

    private void checkNodes() throws IOException {
        JsonArray nodes = json.list("nodes");
        FileLimits.range(file, "the number of nodes", nodes.size(), 0, ModelLimits.MAX_NODES);
        parent = new int[nodes.size()];
        for (int i = 0; i < nodes.size(); i++) {
            String what = "nodes[" + i + "]";
            JsonObject node = json.object(nodes, "nodes", i);
            for (JsonElement child : json.list(node, what, "children")) {
                int number = json.index(child, what + ".children", nodes.size());
                if (parent[number] != 0) {
                    throw FileLimits.wrong(file, what + ".children", number, "a node that has no other parent");
                }
                parent[number] = i + 1;
            }
            json.optional(node, what, "mesh", "meshes");
            json.optional(node, what, "skin", "skins");
            AffineMatrix.of(json, node, what);
        }
        for (int i = 0; i < nodes.size(); i++) {
            int depth = 0;
            for (int up = parent[i]; up != 0; up = parent[up - 1]) {
                if (++depth > ModelLimits.MAX_DEPTH) {
                    throw FileLimits.wrong(file, "nodes[" + i + "]", "nested without end or too deep", "a tree at most "
                        + ModelLimits.MAX_DEPTH + " deep");
                }
            }
        }
    }

    private void checkScenes() throws IOException {
        JsonArray scenes = json.list("scenes");
        if (scenes.size() == 0) {
            throw FileLimits.wrong(file, "scenes", "missing", "a list with the scene of the model");
        }
        json.optional(json.root, "", "scene", "scenes");
        for (int i = 0; i < scenes.size(); i++) {
            boolean[] shown = new boolean[parent.length];
            String what = "scenes[" + i + "]";
            for (JsonElement node : json.list(json.object(scenes, "scenes", i), what, "nodes")) {
                int number = json.index(node, what + ".nodes", parent.length);
                if (parent[number] != 0 || shown[number]) {
                    throw FileLimits.wrong(file, what + ".nodes", number,
                        "a node without a parent, at most once in a scene");
                }
                shown[number] = true;
            }
        }
    }

    private void checkBuffers() throws IOException {
        JsonArray buffers = json.list("buffers");
        for (int i = 0; i < buffers.size(); i++) {
            JsonObject buffer = json.object(buffers, "buffers", i);
            String what = "buffers[" + i + "]";
            String uri = json.text(buffer, what, "uri", null);
            FileLimits.range(file, what + ".byteLength", json.whole(buffer, what, "byteLength", -1, -1, MAX_BYTES), 0,
                files.size(i, uri));
        }
        JsonArray views = json.list("bufferViews");
        for (int i = 0; i < views.size(); i++) {
            JsonObject view = json.object(views, "bufferViews", i);
            String what = "bufferViews[" + i + "]";
            JsonObject buffer = json.object(buffers, "buffers", json.reference(view, what, "buffer", "buffers"));
            long room = json.whole(buffer, what, "byteLength", 0, 0, MAX_BYTES);
            long offset = json.whole(view, what, "byteOffset", 0, 0, room);
            FileLimits.range(file, what + ".byteLength", json.whole(view, what, "byteLength", -1, -1, MAX_BYTES), 0,
                room - offset);
            json.whole(view, what, "byteStride", 0, 0, 252);
        }
    }

    private void checkAccessors() throws IOException {
        JsonArray accessors = json.list("accessors");
        for (int i = 0; i < accessors.size(); i++) {
            JsonObject accessor = json.object(accessors, "accessors", i);
            String what = "accessors[" + i + "]";
            long count = count(accessor, what);
            FileLimits.range(file, what + ".count", count, 1, 3L * ModelLimits.MAX_TRIANGLES);
            int type = (int) json.whole(accessor, what, "componentType", -1, -1, Integer.MAX_VALUE);
            Integer components = COMPONENTS.get(json.text(accessor, what, "type", ""));
            if (!BYTES.containsKey(type) || components == null) {
                throw FileLimits.wrong(file, what, accessor, "a componentType of " + new TreeSet<>(BYTES.keySet())
                    + " and a type of "
                    + new TreeSet<>(COMPONENTS.keySet()));
            }
            json.flag(accessor, what, "normalized");
            checkView(accessor, what, count, (long) BYTES.get(type) * components);
            if (accessor.has("sparse")) {
                checkSparse(json.object(accessor, what, "sparse"), what + ".sparse", count,
                    (long) BYTES.get(type) * components);
            }
        }
    }

    private long count(JsonObject in, String what) throws IOException {
        return json.whole(in, what, "count", -1, Integer.MIN_VALUE, 1L << 40);
    }

    private void checkSparse(JsonObject sparse, String what, long all, long size) throws IOException {
        long count = count(sparse, what);
        FileLimits.range(file, what + ".count", count, 1, all);
        JsonObject indices = json.object(sparse, what, "indices");
        JsonObject values = json.object(sparse, what, "values");
        int type = (int) json.whole(indices, what + ".indices", "componentType", -1, -1, Integer.MAX_VALUE);
        if (!UNSIGNED.contains(type)) {
            throw FileLimits.wrong(file, what + ".indices.componentType", type, "one of " + UNSIGNED);
        }
        json.reference(indices, what + ".indices", "bufferView", "bufferViews");
        json.reference(values, what + ".values", "bufferView", "bufferViews");
        checkView(indices, what + ".indices", count, BYTES.get(type));
        checkView(values, what + ".values", count, size);
    }

    /** Checks that elements lie in their view. */
    private void checkView(JsonObject in, String what, long count, long size) throws IOException {
        if (in.has("bufferView")) {
            int number = json.reference(in, what, "bufferView", "bufferViews");
            JsonObject view = json.object(json.list("bufferViews"), "bufferViews", number);
            long bytes = json.whole(view, "bufferViews[" + number + "]", "byteLength", 0, 0, MAX_BYTES);
            long stride = Math.max(size, json.whole(view, "bufferViews[" + number + "]", "byteStride", 0, 0, 252));
            long offset = json.whole(in, what, "byteOffset", 0, 0, bytes);
            FileLimits.range(file, what + ".count", count, 1, bytes - offset < size ? 0
                : (bytes - offset - size) / stride + 1);
        }
    }

    private void checkMeshes() throws IOException {
        JsonArray meshes = json.list("meshes");
        for (int i = 0; i < meshes.size(); i++) {
            JsonObject mesh = json.object(meshes, "meshes", i);
            JsonArray primitives = json.list(mesh, "meshes[" + i + "]", "primitives");
            for (int p = 0; p < primitives.size(); p++) {
                String what = "meshes[" + i + "].primitives[" + p + "]";
                JsonObject primitive = json.object(primitives, "meshes[" + i + "].primitives", p);
                json.whole(primitive, what, "mode", 4, 0, 6);
                json.optional(primitive, what, "indices", "accessors");
                json.optional(primitive, what, "material", "materials");
                checkAttributes(what + ".attributes", json.object(primitive, what, "attributes"));
                JsonArray targets = json.list(primitive, what, "targets");
                for (int t = 0; t < targets.size(); t++) {
                    checkAttributes(what + ".targets[" + t + "]", json.object(targets, what + ".targets", t));
                }
            }
        }
    }

    private void checkAttributes(String what, JsonObject attributes) throws IOException {
        for (String name : attributes.keySet()) {
            json.reference(attributes, what, name, "accessors");
        }
    }

    private void checkSkins() throws IOException {
        JsonArray skins = json.list("skins");
        for (int i = 0; i < skins.size(); i++) {
            JsonObject skin = json.object(skins, "skins", i);
            String what = "skins[" + i + "]";
            json.optional(skin, what, "inverseBindMatrices", "accessors");
            JsonArray joints = json.list(skin, what, "joints");
            FileLimits.range(file, "the number of " + what + ".joints", joints.size(), 1, ModelLimits.MAX_NODES);
            for (JsonElement joint : joints) {
                json.index(joint, what + ".joints", parent.length);
            }
        }
    }

    private void checkPictures() throws IOException {
        JsonArray images = json.list("images");
        for (int i = 0; i < images.size(); i++) {
            json.optional(json.object(images, "images", i), "images[" + i + "]", "bufferView", "bufferViews");
        }
        JsonArray textures = json.list("textures");
        for (int i = 0; i < textures.size(); i++) {
            json.optional(json.object(textures, "textures", i), "textures[" + i + "]", "source", "images");
        }
        JsonArray materials = json.list("materials");
        for (int i = 0; i < materials.size(); i++) {
            json.object(materials, "materials", i);
        }
    }

    private void checkAnimations() throws IOException {
        JsonArray animations = json.list("animations");
        for (int i = 0; i < animations.size(); i++) {
            JsonObject animation = json.object(animations, "animations", i);
            String what = "animations[" + i + "]";
            JsonArray channels = json.list(animation, what, "channels");
            JsonArray samplers = json.list(animation, what, "samplers");
            for (int c = 0; c < channels.size(); c++) {
                JsonObject channel = json.object(channels, what + ".channels", c);
                json.index(channel.get("sampler"), what + ".channels.sampler", samplers.size());
                json.optional(json.object(channel, what + ".channels", "target"), what + ".channels.target", "node",
                    "nodes");
            }
            for (int s = 0; s < samplers.size(); s++) {
                JsonObject sampler = json.object(samplers, what + ".samplers", s);
                json.reference(sampler, what + ".samplers", "input", "accessors");
                json.reference(sampler, what + ".samplers", "output", "accessors");
            }
        }
    }
}
