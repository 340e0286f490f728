// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import com.jme3.asset.AssetInfo;
import com.jme3.asset.AssetKey;
import com.jme3.asset.AssetLoadException;
import com.jme3.asset.TextureKey;
import com.jme3.material.Material;
import com.jme3.math.ColorRGBA;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;
import com.jme3.scene.plugins.gltf.GltfLoader;
import com.jme3.texture.Texture2D;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import org.SEAR.files.FileLimits;

/**
 * Reader of glTF 2.0 (Khronos, "glTF 2.0 specification"). The surface is SEAR's own work, see {@link GltfScene}, since
 * jMonkeyEngine's scene can't shear; the materials are those of jMonkeyEngine's reader. One use.
 */
public final class GltfReader extends GltfLoader {
    /** Parts of the file that jMonkeyEngine's reader needs for materials. */
    private static final String[] FOR_MATERIALS = {"materials", "textures", "images", "samplers", "bufferViews",
        "buffers"};

    private final AssetInfo info;
    private final String file;
    private final GltfJson json;
    private final byte[] chunk;
    private final byte[][] buffers;
    private final Map<String, Texture2D> pictures = new HashMap<>();
    private int[] parents;

    /** @param chunk binary chunk of a .glb; empty if there is none */
    public GltfReader(AssetInfo info, byte[] text, byte[] chunk) throws IOException {
        this.info = info;
        this.file = info.getKey().getName();
        this.chunk = chunk;
        json = new GltfJson(file, text);
        buffers = new byte[json.list("buffers").size()][];
    }

    /**
     * Returns the model.
     *
     * @throws IOException that names the value and the legal values
     */
    public Node read() throws IOException {
        parents = new GltfCheck(json, (number, uri) -> (buffers[number] = read(number, uri)).length).check();
        JsonObject needed = new JsonObject();
        for (String name : FOR_MATERIALS) {
            if (json.root.has(name)) {
                needed.add(name, name.equals("buffers") ? withoutData(json.list(name)) : json.root.get(name));
            }
        }
        needed.add("asset", json.root.get("asset"));
        needed.add("nodes", new JsonArray());
        try {
            return (Node) loadFromStream(info,
                new ByteArrayInputStream(needed.toString().getBytes(StandardCharsets.UTF_8)));
        } catch (AssetLoadException e) {
            if (e.getCause() instanceof IOException) {
                throw (IOException) e.getCause();
            }
            throw e;
        }
    }

    private static JsonArray withoutData(JsonArray all) {
        JsonArray result = new JsonArray();
        for (JsonElement buffer : all) {
            JsonObject length = new JsonObject();
            length.add("byteLength", buffer.getAsJsonObject().get("byteLength"));
            result.add(length);
        }
        return result;
    }

    private byte[] read(int number, String uri) throws IOException {
        String what = "buffers[" + number + "].uri";
        if (uri == null) {
            return number == 0 ? chunk : new byte[0];
        }
        if (!uri.startsWith("data:")) {
            return file(uri);
        }
        try {
            int comma = uri.indexOf(',');
            if (comma > 0) {
                return Base64.getDecoder().decode(uri.substring(comma + 1));
            }
        } catch (IllegalArgumentException e) {
            throw FileLimits.wrong(file, what, uri, "data in Base64", e);
        }
        throw FileLimits.wrong(file, what, uri, "data:application/octet-stream;base64,...");
    }

    private byte[] file(String uri) throws IOException {
        for (String name : new String[] {uri, decoded(uri)}) {
            AssetInfo found = info.getManager().locateAsset(new AssetKey<>(info.getKey().getFolder() + name));
            if (found != null) {
                try (InputStream in = found.openStream()) {
                    byte[] bytes = in.readNBytes((int) ModelLimits.MAX_FILE + 1);
                    FileLimits.range(file, "the size of " + uri, bytes.length, 0, ModelLimits.MAX_FILE);
                    return bytes;
                }
            }
        }
        throw FileLimits.wrong(file, "a buffer's uri", uri, "a file beside the model");
    }

    private static String decoded(String uri) {
        try {
            return URLDecoder.decode(uri.replace("+", "%2B"), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException e) {
            return uri;         // has a percent sign of its own
        }
    }

    @Override
    public void readScenes(JsonPrimitive scene, Node root) throws IOException {
        Node model = new Node(file);
        for (GltfScene.Part part : new GltfScene(json, new GltfAccessors(json, number -> buffers[number]),
            parents).parts()) {
            Mesh mesh = part.mesh.mesh();
            addToCache("mesh", 0, mesh, 1);     // of which an extension of the material changes texture coordinates
            model.attachChild(SolidMesh.geometry(part.name, mesh, part.material < 0 ? white()
            : readMaterial(part.material)));
        }
        root.attachChild(model);
    }

    private Material white() {
        Material white = new Material(info.getManager(), "Common/MatDefs/Light/PBRLighting.j3md");
        white.setColor("BaseColor", ColorRGBA.White);
        white.setFloat("Metallic", 0);
        white.setFloat("Roughness", 1);
        return white;
    }

    @Override
    public Material readMaterial(int number) throws IOException {
        try {
            return super.readMaterial(number);
        } catch (AssetLoadException e) {
            throw e;
        } catch (RuntimeException e) {
            throw FileLimits.wrong(file, "materials[" + number + "]", json.list("materials").get(number),
                "a material of glTF 2.0 whose textures exist", e);
        }
    }

    @Override
    protected byte[] getBytes(int number, String uri, Integer length) {
        return buffers[number];
    }

    @Override
    public Texture2D readTexture(JsonObject texture, boolean flip) throws IOException {
        boolean missing = texture != null && !json.object(json.list("textures"), "textures",
            json.reference(texture, "a texture", "index", "textures")).has("source");
        return missing ? missing("textures[" + texture.get("index") + "] without a source") : super.readTexture(texture,
            flip);
    }

    /** Returns a picture, read once. */
    @Override
    public Texture2D readImage(int number, boolean flip) throws IOException {
        String key = number + " " + flip;
        if (!pictures.containsKey(key)) {
            pictures.put(key, picture(number, flip));
        }
        return (Texture2D) pictures.get(key).clone();
    }

    private Texture2D picture(int number, boolean flip) throws IOException {
        JsonObject image = json.object(json.list("images"), "images", number);
        String uri = json.text(image, "images[" + number + "]", "uri", null);
        String type = json.text(image, "images[" + number + "]", "mimeType", "");
        boolean readable = uri == null ? image.has("bufferView") && type.matches("image/\\w+")
            : !uri.startsWith("data:") || uri.matches("data:image/\\w+;base64,[A-Za-z0-9+/]+=*");
        return readable ? super.readImage(number, flip) : missing("images[" + number
            + "] without data in Base64 and its type");
    }

    /** Returns the replacement of a missing picture. */
    private Texture2D missing(String name) {
        return (Texture2D) info.getManager().loadTexture(new TextureKey(name));
    }
}
