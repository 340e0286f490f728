package org.SEAR.project.models;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.SEAR.files.FileLimits;

/**
 * Checks the JSON of a glTF 2.0 file before a loader uses it: nodes form a tree, each reference is valid, and each
 * accessor lies in its view, each view in its buffer, each buffer in the file. One use.
 */
final class GltfCheck {
    private static final Map<String, Integer> COMPONENTS = Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4, "MAT2", 4, "MAT3", 9, "MAT4", 16);
    private static final Map<Integer, Integer> BYTES = Map.of(5120, 1, 5121, 1, 5122, 2, 5123, 2, 5125, 4, 5126, 4);

    /** Extensions that jMonkeyEngine's reader supports. */
    private static final Set<String> EXTENSIONS = Set.of("KHR_materials_pbrSpecularGlossiness", "KHR_lights_punctual", "KHR_materials_unlit",
        "KHR_texture_transform");
    private static final Map<String, Integer> PLACE = Map.of("matrix", 16, "translation", 3, "rotation", 4, "scale", 3);

    /** Sizes of the files of buffers. */
    interface Files {
        /**
         * @return bytes
         * @throws IOException if there is no such file
         */
        long size(String uri) throws IOException;
    }

    private final String file;
    private final JsonObject root;
    private final Files files;
    private final long chunk;

    /** @param chunk bytes of the binary chunk of a .glb; 0 if there is none */
    GltfCheck(String file, byte[] json, long chunk, Files files) throws IOException {
        this.file = file;
        this.chunk = chunk;
        this.files = files;
        try {
            JsonElement parsed = JsonParser.parseString(new String(json, StandardCharsets.UTF_8));
            if (!parsed.isJsonObject()) {
                throw FileLimits.wrong(file, "the text", parsed, "a JSON object");
            }
            root = parsed.getAsJsonObject();
        } catch (JsonParseException | StackOverflowError e) {
            throw new IOException(file + ": it is no JSON (" + e.getMessage() + ")", e);
        }
    }

    void check() throws IOException {
        try {
            checkExtensions();
            checkNodes();
            checkBuffers();
            checkAccessors();
            checkMeshes();
            checkPictures();
            checkAnimations();
        } catch (IllegalStateException | ClassCastException | UnsupportedOperationException | NumberFormatException e) {
            throw new IOException(file + ": a value has another type than glTF 2.0 requires (" + e.getMessage() + ")", e);
        }
    }

    /**
     * Rejects required extensions that the reader does not support: without them the shape is wrong, for example all
     * compressed vertices lie in one point.
     */
    private void checkExtensions() throws IOException {
        for (JsonElement needed : list(root, "extensionsRequired")) {
            if (!EXTENSIONS.contains(needed.getAsString())) {
                throw FileLimits.wrong(file, "a required extension", needed.getAsString(), "one of "
                    + String.join(", ", new TreeSet<>(EXTENSIONS)) + ": export it without compression and other extensions");
            }
        }
    }

    private void checkNodes() throws IOException {
        JsonArray nodes = list(root, "nodes");
        FileLimits.range(file, "the number of nodes", nodes.size(), 0, ModelLimits.MAX_NODES);
        int[] parent = new int[nodes.size()];
        for (int i = 0; i < nodes.size(); i++) {
            JsonObject node = nodes.get(i).getAsJsonObject();
            for (JsonElement child : list(node, "children")) {
                int number = reference("nodes[" + i + "].children", child, nodes.size());
                if (parent[number] != 0) {
                    throw FileLimits.wrong(file, "nodes[" + i + "].children", number, "a node that has no other parent");
                }
                parent[number] = i + 1;
            }
            optional(node, "nodes[" + i + "]", "mesh", list(root, "meshes").size());
            for (Map.Entry<String, Integer> numbers : PLACE.entrySet()) {
                JsonArray given = list(node, numbers.getKey());
                FileLimits.range(file, "the number of numbers of nodes[" + i + "]." + numbers.getKey(), given.size(),
                    node.has(numbers.getKey()) ? numbers.getValue() : 0, numbers.getValue());
            }
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
        checkScenes(parent);
    }

    private void checkScenes(int[] parent) throws IOException {
        boolean[] shown = new boolean[parent.length];
        JsonArray scenes = list(root, "scenes");
        optional(root, "", "scene", scenes.size());
        for (int i = 0; i < scenes.size(); i++) {
            for (JsonElement node : list(scenes.get(i).getAsJsonObject(), "nodes")) {
                int number = reference("scenes[" + i + "].nodes", node, parent.length);
                if (parent[number] != 0 || shown[number]) {
                    throw FileLimits.wrong(file, "scenes[" + i + "].nodes", number, "a node without a parent, once in all scenes");
                }
                shown[number] = true;
            }
        }
    }

    private void checkBuffers() throws IOException {
        JsonArray buffers = list(root, "buffers");
        for (int i = 0; i < buffers.size(); i++) {
            JsonObject buffer = buffers.get(i).getAsJsonObject();
            String what = "buffers[" + i + "]";
            FileLimits.range(file, what + ".byteLength", number(buffer, what, "byteLength", -1), 0, size(buffer, what));
        }
        JsonArray views = list(root, "bufferViews");
        for (int i = 0; i < views.size(); i++) {
            JsonObject view = views.get(i).getAsJsonObject();
            String what = "bufferViews[" + i + "]";
            JsonObject buffer = buffers.get(reference(what + ".buffer", view.get("buffer"), buffers.size())).getAsJsonObject();
            long offset = number(view, what, "byteOffset", 0);
            long room = number(buffer, what, "byteLength", 0);
            FileLimits.range(file, what + ".byteOffset", offset, 0, room);
            FileLimits.range(file, what + ".byteLength", number(view, what, "byteLength", -1), 0, room - offset);
            FileLimits.range(file, what + ".byteStride", number(view, what, "byteStride", 0), 0, 252);
        }
    }

    private long size(JsonObject buffer, String what) throws IOException {
        if (!buffer.has("uri")) {
            return chunk;
        }
        String uri = buffer.get("uri").getAsString();
        if (!uri.startsWith("data:")) {
            return files.size(uri);
        }
        int comma = uri.indexOf(',');
        if (comma < 0) {
            throw FileLimits.wrong(file, what + ".uri", uri, "data:application/octet-stream;base64,...");
        }
        return (uri.length() - comma - 1L) * 3 / 4;
    }

    private void checkAccessors() throws IOException {
        JsonArray views = list(root, "bufferViews");
        JsonArray accessors = list(root, "accessors");
        for (int i = 0; i < accessors.size(); i++) {
            JsonObject accessor = accessors.get(i).getAsJsonObject();
            String what = "accessors[" + i + "]";
            long count = number(accessor, what, "count", -1);
            FileLimits.range(file, what + ".count", count, 1, 3L * ModelLimits.MAX_TRIANGLES);
            Integer width = BYTES.get((int) number(accessor, what, "componentType", -1));
            Integer components = COMPONENTS.get(accessor.has("type") ? accessor.get("type").getAsString() : "");
            if (width == null || components == null) {
                throw FileLimits.wrong(file, what, accessor, "a componentType of " + BYTES.keySet() + " and a type of " + COMPONENTS.keySet());
            }
            if (accessor.has("sparse")) {
                throw FileLimits.wrong(file, what + ".sparse", "there", "accessors without sparse; export the model without it");
            }
            if (accessor.has("bufferView")) {
                JsonObject view = views.get(reference(what + ".bufferView", accessor.get("bufferView"), views.size())).getAsJsonObject();
                long size = (long) width * components;
                long stride = Math.max(size, number(view, what, "byteStride", 0));
                long offset = number(accessor, what, "byteOffset", 0);
                FileLimits.range(file, what + ".byteOffset", offset, 0, number(view, what, "byteLength", 0));
                FileLimits.range(file, what + ".count", count, 1, room(number(view, what, "byteLength", 0) - offset, size, stride));
            }
        }
    }

    /** Returns the number of elements that fit. */
    private static long room(long bytes, long size, long stride) {
        return bytes < size ? 0 : (bytes - size) / stride + 1;
    }

    private void checkMeshes() throws IOException {
        int accessors = list(root, "accessors").size();
        JsonArray meshes = list(root, "meshes");
        for (int i = 0; i < meshes.size(); i++) {
            for (JsonElement element : list(meshes.get(i).getAsJsonObject(), "primitives")) {
                JsonObject primitive = element.getAsJsonObject();
                String what = "meshes[" + i + "].primitives";
                optional(primitive, what, "indices", accessors);
                optional(primitive, what, "material", list(root, "materials").size());
                if (!primitive.has("attributes")) {
                    throw FileLimits.wrong(file, what + ".attributes", "missing", "an object with POSITION");
                }
                checkAttributes(what + ".attributes", primitive.getAsJsonObject("attributes"), accessors);
                for (JsonElement target : list(primitive, "targets")) {
                    checkAttributes(what + ".targets", target.getAsJsonObject(), accessors);
                }
            }
        }
    }

    private void checkAttributes(String what, JsonObject attributes, int accessors) throws IOException {
        for (Map.Entry<String, JsonElement> attribute : attributes.entrySet()) {
            reference(what + "." + attribute.getKey(), attribute.getValue(), accessors);
        }
    }

    private void checkPictures() throws IOException {
        JsonArray images = list(root, "images");
        for (int i = 0; i < images.size(); i++) {
            optional(images.get(i).getAsJsonObject(), "images[" + i + "]", "bufferView", list(root, "bufferViews").size());
        }
        JsonArray textures = list(root, "textures");
        for (int i = 0; i < textures.size(); i++) {
            optional(textures.get(i).getAsJsonObject(), "textures[" + i + "]", "source", images.size());
        }
    }

    private void checkAnimations() throws IOException {
        JsonArray animations = list(root, "animations");
        for (int i = 0; i < animations.size(); i++) {
            JsonObject animation = animations.get(i).getAsJsonObject();
            String what = "animations[" + i + "]";
            for (JsonElement channel : list(animation, "channels")) {
                reference(what + ".channels.sampler", channel.getAsJsonObject().get("sampler"), list(animation, "samplers").size());
                if (!channel.getAsJsonObject().has("target")) {
                    throw FileLimits.wrong(file, what + ".channels.target", "missing", "an object");
                }
                optional(channel.getAsJsonObject().getAsJsonObject("target"), what + ".channels.target", "node", list(root, "nodes").size());
            }
            for (JsonElement sampler : list(animation, "samplers")) {
                reference(what + ".samplers.input", sampler.getAsJsonObject().get("input"), list(root, "accessors").size());
                reference(what + ".samplers.output", sampler.getAsJsonObject().get("output"), list(root, "accessors").size());
            }
        }
    }

    private static JsonArray list(JsonObject in, String name) {
        return in.has(name) ? in.getAsJsonArray(name) : new JsonArray();
    }

    private void optional(JsonObject in, String what, String name, int count) throws IOException {
        if (in.has(name)) {
            reference(what.isEmpty() ? name : what + "." + name, in.get(name), count);
        }
    }

    private int reference(String what, JsonElement value, int count) throws IOException {
        if (value == null) {
            throw FileLimits.wrong(file, what, "missing", range(count));
        }
        double number = value.getAsDouble();
        if (!(number >= 0 && number < count)) {
            throw FileLimits.wrong(file, what, value, range(count));
        }
        return (int) number;
    }

    private static String range(int count) {
        return count == 0 ? "nothing, because there are none" : "0 to " + (count - 1);
    }

    private long number(JsonObject in, String what, String name, long missing) throws IOException {
        if (!in.has(name)) {
            return missing;
        }
        double number = in.get(name).getAsDouble();
        if (!(Math.abs(number) < 1L << 40)) {
            throw FileLimits.wrong(file, what + "." + name, in.get(name), "a whole number of bytes or elements");
        }
        return (long) number;
    }
}
