package org.SEAR.project.models;

import com.google.gson.JsonObject;
import com.jme3.asset.AssetInfo;
import com.jme3.asset.AssetKey;
import com.jme3.asset.AssetLoader;
import com.jme3.asset.AssetManager;
import com.jme3.asset.TextureKey;
import com.jme3.export.binary.BinaryLoader;
import com.jme3.material.plugins.J3MLoader;
import com.jme3.scene.plugins.MTLLoader;
import com.jme3.scene.plugins.OBJLoader;
import com.jme3.scene.plugins.blender.BlenderContext;
import com.jme3.scene.plugins.blender.BlenderLoader;
import com.jme3.scene.plugins.blender.file.BlenderFileException;
import com.jme3.scene.plugins.blender.file.FileBlockHeader;
import com.jme3.scene.plugins.blender.file.Structure;
import com.jme3.scene.plugins.gltf.GlbLoader;
import com.jme3.scene.plugins.gltf.GltfLoader;
import com.jme3.scene.plugins.ogre.MaterialLoader;
import com.jme3.scene.plugins.ogre.MeshLoader;
import com.jme3.scene.plugins.ogre.SceneLoader;
import com.jme3.scene.plugins.ogre.SkeletonLoader;
import com.jme3.texture.Texture2D;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.GZIPInputStream;
import org.SEAR.files.FileLimits;

/**
 * Guarded versions of jMonkeyEngine's loaders, which trust their files: OGRE XML can read other files through entities,
 * a .j3o names the Java classes to create, a .blend links to arbitrary files. Projects are untrusted, so these loaders
 * check each file first. jMonkeyEngine keeps one loader per thread, and its own loaders keep the last file; a guarded
 * loader creates a new one per file and keeps nothing.
 */
final class GuardedLoaders {
    private static final int GLB_MARK = 0x46546c67;
    private static final int JSON_CHUNK = 0x4e4f534a;
    /** Offset of the JSON of a .glb, bytes. */
    private static final int GLB_DATA = 20;
    private static final int PIECE = 1 << 16;
    private static final byte[] GZIP = {0x1f, (byte) 0x8b};
    /** Element counts for which OGRE's reader allocates memory before it reads the elements. */
    private static final Pattern COUNT = Pattern.compile("\\b(?:vertex)?count\\s*=\\s*[\"'](\\d+)", Pattern.CASE_INSENSITIVE);
    /** Shortest element of OGRE's XML, bytes. */
    private static final int SHORTEST = 10;

    private GuardedLoaders() {
    }

    /**
     * Replaces the unguarded loaders.
     *
     * @param pixels whether the pictures are needed
     */
    static void register(AssetManager manager, boolean pixels) {
        manager.unregisterLoader(SceneLoader.class);
        manager.unregisterLoader(GltfLoader.class);
        manager.unregisterLoader(GlbLoader.class);
        manager.registerLoader(Obj.class, "obj");
        manager.registerLoader(Mtl.class, "mtl");
        manager.registerLoader(OgreMaterial.class, "material");
        manager.registerLoader(EngineMaterial.class, "j3m", "j3md");
        manager.registerLoader(Mesh.class, "meshxml", "mesh.xml");
        manager.registerLoader(Skeleton.class, "skeletonxml", "skeleton.xml");
        manager.registerLoader(Binary.class, "j3o", "j3f");
        manager.registerLoader(Blend.class, "blend");
        manager.registerLoader(Gltf.class, "gltf");
        manager.registerLoader(Glb.class, "glb");
        PictureLoader.register(manager, pixels);
    }

    /**
     * Wavefront models. jMonkeyEngine's reader logs each line without triangles, a million for some files, and missing
     * normals, which the window computes itself.
     */
    public static final class Obj implements AssetLoader {
        private static final Logger LINES = Logger.getLogger(OBJLoader.class.getName());

        static {
            LINES.setLevel(Level.SEVERE);
        }

        @Override
        public Object load(AssetInfo info) throws IOException {
            return new OBJLoader().load(new Checked(info, new ObjText(info.getKey().getName()).read(bytes(info))));
        }
    }

    public static final class Mtl implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new MTLLoader().load(info);
        }
    }

    public static final class OgreMaterial implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new MaterialLoader().load(info);
        }
    }

    public static final class EngineMaterial implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new J3MLoader().load(info);
        }
    }

    /** glTF with valid references. */
    public static final class Gltf implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            byte[] json = bytes(info);
            new GltfCheck(info.getKey().getName(), json, 0, uri -> size(info, uri)).check();
            return new GltfLoader() {
                @Override
                public Texture2D readTexture(JsonObject texture, boolean flip) throws IOException {
                    return lacksPicture(this, texture) ? missing(info, texture) : super.readTexture(texture, flip);
                }
            }.load(new Checked(info, json));
        }
    }

    /**
     * Returns whether a texture has no plain picture, only one by an extension that jMonkeyEngine's reader does not
     * support.
     */
    private static boolean lacksPicture(GltfLoader loader, JsonObject texture) {
        return texture != null && !loader.getDocRoot().getAsJsonArray("textures").get(texture.get("index").getAsInt()).getAsJsonObject()
            .has("source");
    }

    /** Returns the replacement texture for a missing picture. */
    private static Texture2D missing(AssetInfo model, JsonObject texture) {
        return (Texture2D) model.getManager().loadTexture(new TextureKey("textures[" + texture.get("index") + "] without a source"));
    }

    /** Binary glTF: a header of 12 bytes, a JSON chunk and a data chunk, each after its length and kind. */
    public static final class Glb implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            byte[] bytes = bytes(info);
            String name = info.getKey().getName();
            ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
            FileLimits.range(name, "the file's size", bytes.length, GLB_DATA, ModelLimits.MAX_FILE);
            if (in.getInt(0) != GLB_MARK || in.getInt(4) != 2 || in.getInt(GLB_DATA - 4) != JSON_CHUNK) {
                throw FileLimits.wrong(name, "the head", "another one", "a .glb of glTF 2 that starts with its JSON");
            }
            FileLimits.range(name, "the length in the head", in.getInt(8), GLB_DATA, bytes.length);
            int json = in.getInt(GLB_DATA - 8);
            FileLimits.range(name, "the length of the JSON", json, 2, bytes.length - GLB_DATA);
            long data = 0;
            int chunk = GLB_DATA + json;
            while (chunk + 8 <= bytes.length) {
                long length = in.getInt(chunk);
                FileLimits.range(name, "the length of a chunk", length, 0, bytes.length - chunk - 8);
                data = Math.max(data, length);
                chunk += 8 + (int) length;
            }
            new GltfCheck(name, Arrays.copyOfRange(bytes, GLB_DATA, GLB_DATA + json), data, uri -> size(info, uri)).check();
            return new GlbLoader() {
                @Override
                public Texture2D readTexture(JsonObject texture, boolean flip) throws IOException {
                    return lacksPicture(this, texture) ? missing(info, texture) : super.readTexture(texture, flip);
                }
            }.load(new Checked(info, bytes));
        }
    }

    /** Returns the size of a file beside a model, up to the limit. */
    private static long size(AssetInfo model, String uri) throws IOException {
        for (String name : new String[] {uri, URLDecoder.decode(uri.replace("+", "%2B"), StandardCharsets.UTF_8)}) {
            AssetInfo found = model.getManager().locateAsset(new AssetKey<>(model.getKey().getFolder() + name));
            if (found != null) {
                try (InputStream in = found.openStream()) {
                    return in.skip(ModelLimits.MAX_FILE);
                }
            }
        }
        throw FileLimits.wrong(model.getKey().getName(), "a buffer's uri", uri, "a file beside the model");
    }

    /** OGRE meshes without document type. */
    public static final class Mesh implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new MeshLoader().load(xml(info));
        }
    }

    /** OGRE skeletons without document type. */
    public static final class Skeleton implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new SkeletonLoader().load(xml(info));
        }
    }

    /** jMonkeyEngine's own format, with scene classes only. */
    public static final class Binary implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            byte[] bytes = bytes(info);
            new J3oCheck(info.getKey().getName(), bytes).check();
            return new BinaryLoader().load(new Checked(info, bytes));
        }
    }

    /** Blender files, packed or not. */
    public static final class Blend implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new Unlinked().load(new Checked(info, unpacked(info)));
        }

        private static byte[] unpacked(AssetInfo info) throws IOException {
            byte[] bytes = bytes(info);
            if (!Arrays.equals(GZIP, Arrays.copyOf(bytes, GZIP.length))) {
                return bytes;
            }
            int size = unpackedSize(bytes);
            if (size > ModelLimits.MAX_BLEND) {
                throw FileLimits.wrong(info.getKey().getName(), "the unpacked size", "more than " + ModelLimits.MAX_BLEND,
                    "at most " + ModelLimits.MAX_BLEND + " bytes; save it unpacked in Blender, or export .glb");
            }
            try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(bytes))) {
                return in.readNBytes(size);
            }
        }

        /** Returns the unpacked size without keeping the data; stops soon after the limit. */
        private static int unpackedSize(byte[] packed) throws IOException {
            byte[] piece = new byte[PIECE];
            int size = 0;
            try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(packed))) {
                for (int read = in.read(piece); read >= 0 && size <= ModelLimits.MAX_BLEND; read = in.read(piece)) {
                    size += read;
                }
            }
            return size;
        }
    }

    /** Blender files without links to other files, which could lie anywhere on the disk. */
    private static final class Unlinked extends BlenderLoader {
        /** Structure with the path of another file; jMonkeyEngine does not know its block code. */
        private static final String LIBRARY = "Library";

        @Override
        protected BlenderContext setup(AssetInfo info) throws BlenderFileException {
            BlenderContext context = super.setup(info);
            info.getManager().unregisterLocator(info.getKey().getName(), LinkedContentLocator.class);
            List<FileBlockHeader> unknown = context.getFileBlocks(FileBlockHeader.BlockCode.BLOCK_UNKN);
            for (FileBlockHeader block : unknown == null ? List.<FileBlockHeader>of() : unknown) {
                Structure data = block.getStructure(context);
                if (data != null && LIBRARY.equals(data.getType())) {
                    throw new BlenderFileException(info.getKey().getName() + " links to other files, which a model may not:"
                        + " in Blender make everything local (File, Append instead of Link), or export .glb");
                }
            }
            return context;
        }

        @Override
        protected void clear(AssetInfo info) {
            // setup has already removed the locator of linked files
        }
    }

    private static AssetInfo xml(AssetInfo info) throws IOException {
        byte[] bytes = bytes(info);
        String text = new String(bytes, StandardCharsets.ISO_8859_1).toUpperCase(Locale.ROOT);
        if (text.contains("<!DOCTYPE") || text.contains("<!ENTITY") || text.indexOf('\0') >= 0) {
            throw new IOException(info.getKey().getName() + " has a document type or is not in UTF-8, which is not allowed in a model");
        }
        Matcher count = COUNT.matcher(text);
        while (count.find()) {
            if (count.group(1).length() > 9 || Long.parseLong(count.group(1)) > text.length() / SHORTEST) {
                throw FileLimits.wrong(info.getKey().getName(), "a count", count.group(1), "no more than the file holds, "
                    + text.length() / SHORTEST);
            }
        }
        return new Checked(info, bytes);
    }

    private static byte[] bytes(AssetInfo info) throws IOException {
        try (InputStream in = info.openStream()) {
            byte[] bytes = in.readNBytes((int) ModelLimits.MAX_FILE + 1);
            FileLimits.range(info.getKey().getName(), "the file's size", bytes.length, 1, ModelLimits.MAX_FILE);
            return bytes;
        }
    }

    /** A file that was checked. */
    static final class Checked extends AssetInfo {
        private final byte[] bytes;

        Checked(AssetInfo info, byte[] bytes) {
            super(info.getManager(), info.getKey());
            this.bytes = bytes;
        }

        @Override
        public InputStream openStream() {
            return new ByteArrayInputStream(bytes);
        }
    }
}
