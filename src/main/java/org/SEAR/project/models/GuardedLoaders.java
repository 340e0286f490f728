// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import com.jme3.asset.AssetInfo;
import com.jme3.asset.AssetLoadException;
import com.jme3.asset.AssetLoader;
import com.jme3.asset.AssetManager;
import com.jme3.material.plugins.J3MLoader;
import com.jme3.scene.plugins.MTLLoader;
import com.jme3.scene.plugins.gltf.GlbLoader;
import com.jme3.scene.plugins.gltf.GltfLoader;
import com.jme3.scene.plugins.ogre.MaterialLoader;
import com.jme3.scene.plugins.ogre.SceneLoader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.NoSuchElementException;
import java.util.zip.GZIPInputStream;
import org.SEAR.files.FileLimits;
import org.SEAR.project.models.format.BlendReader;
import org.SEAR.project.models.format.ColladaReader;
import org.SEAR.project.models.format.GltfReader;
import org.SEAR.project.models.format.J3oReader;
import org.SEAR.project.models.format.ModelLimits;
import org.SEAR.project.models.format.ObjReader;
import org.SEAR.project.models.format.OgreReader;
import org.SEAR.project.models.format.PlyReader;
import org.SEAR.project.models.format.StlReader;

/**
 * Guarded versions of jMonkeyEngine's loaders, which trust their files: OGRE XML can read other files through entities,
 * a .j3o names the Java classes to create, a .blend links to arbitrary files. Projects are untrusted, so these loaders
 * check each file first. jMonkeyEngine keeps one loader per thread, and its own loaders keep the last file; a guarded
 * loader creates a new one per file and keeps nothing.
 */
final class GuardedLoaders {
    private static final int GLB_MARK = 0x46546c67;
    private static final int JSON_CHUNK = 0x4e4f534a;
    private static final int BINARY_CHUNK = 0x004e4942;
    /** Offset of the JSON of a .glb, bytes. */
    private static final int GLB_DATA = 20;
    private static final int PIECE = 1 << 16;
    private static final byte[] GZIP = {0x1f, (byte) 0x8b};

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
        manager.registerLoader(Binary.class, "j3o");
        manager.registerLoader(Blend.class, "blend");
        manager.registerLoader(Gltf.class, "gltf");
        manager.registerLoader(Glb.class, "glb");
        manager.registerLoader(Stl.class, "stl");
        manager.registerLoader(Ply.class, "ply");
        manager.registerLoader(Collada.class, "dae");
        PictureLoader.register(manager, pixels);
    }

    public static final class Obj implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new ObjReader(info, bytes(info), text -> ModelAssets.warn(info.getManager(), text)).read();
        }
    }

    public static final class Stl implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new StlReader(info, bytes(info), text -> ModelAssets.warn(info.getManager(), text)).read();
        }
    }

    public static final class Ply implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new PlyReader(info, bytes(info), text -> ModelAssets.warn(info.getManager(), text)).read();
        }
    }

    /** COLLADA files without document type. */
    public static final class Collada implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new ColladaReader(info, xml(info), text -> ModelAssets.warn(info.getManager(), text)).read();
        }
    }

    public static final class Mtl implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return readable(new MTLLoader(), info);
        }
    }

    public static final class OgreMaterial implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return readable(new MaterialLoader(), info);
        }
    }

    /** Returns materials; a model with unreadable ones is plain. */
    private static Object readable(AssetLoader loader, AssetInfo info) throws IOException {
        try {
            return loader.load(info);
        } catch (AssetLoadException e) {
            throw e;            // of a picture beyond a limit
        } catch (NoSuchElementException e) {
            throw new UnreadableMaterials("a line lacks a number", e);
        } catch (IOException | RuntimeException e) {
            throw new UnreadableMaterials("a line is no part of a material", e);
        }
    }

    /** Materials that can't be shown. */
    static final class UnreadableMaterials extends IOException {
        private static final long serialVersionUID = 1;

        UnreadableMaterials(String why, Exception cause) {
            super(why, cause);
        }
    }

    public static final class EngineMaterial implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new J3MLoader().load(info);
        }
    }

    public static final class Gltf implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new GltfReader(info, bytes(info), new byte[0]).read();
        }
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
            byte[] data = {};
            int chunk = GLB_DATA + json;
            while (chunk + 8 <= bytes.length) {
                int length = in.getInt(chunk);
                FileLimits.range(name, "the length of a chunk", length, 0, bytes.length - chunk - 8);
                if (data.length == 0 && in.getInt(chunk + 4) == BINARY_CHUNK) {
                    data = Arrays.copyOfRange(bytes, chunk + 8, chunk + 8 + length);
                }
                chunk += 8 + length;
            }
            return new GltfReader(info, Arrays.copyOfRange(bytes, GLB_DATA, GLB_DATA + json), data).read();
        }
    }

    /** OGRE meshes without document type. */
    public static final class Mesh implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new OgreReader(info, text -> ModelAssets.warn(info.getManager(), text)).read(xml(info));
        }
    }

    /** jMonkeyEngine's own format, with scene classes only. */
    public static final class Binary implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return J3oReader.read(info, bytes(info));
        }
    }

    /** Blender files, packed or not. */
    public static final class Blend implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return new BlendReader(info, text -> ModelAssets.warn(info.getManager(), text)).read(unpacked(info));
        }

        private static byte[] unpacked(AssetInfo info) throws IOException {
            byte[] bytes = bytes(info);
            if (!Arrays.equals(GZIP, Arrays.copyOf(bytes, GZIP.length))) {
                return bytes;
            }
            int size = unpackedSize(bytes, info.getKey().getName());
            if (size > ModelLimits.MAX_BLEND) {
                throw FileLimits.wrong(info.getKey().getName(), "the unpacked size", "more than "
                    + ModelLimits.MAX_BLEND,
                    "at most " + ModelLimits.MAX_BLEND + " bytes; save it unpacked in Blender, or export .glb");
            }
            try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(bytes))) {
                return in.readNBytes(size);
            }
        }

        /** Returns the unpacked size without keeping the data; stops soon after the limit. */
        private static int unpackedSize(byte[] packed, String file) throws IOException {
            byte[] piece = new byte[PIECE];
            int size = 0;
            try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(packed))) {
                for (int read = in.read(piece); read >= 0 && size <= ModelLimits.MAX_BLEND; read = in.read(piece)) {
                    size += read;
                }
            } catch (IOException e) {
                throw FileLimits.wrong(file, "the gzip data after " + size + " unpacked bytes", "cut off or damaged",
                    "a whole file", e);
            }
            return size;
        }
    }

    private static byte[] xml(AssetInfo info) throws IOException {
        byte[] bytes = bytes(info);
        String text = new String(bytes, StandardCharsets.ISO_8859_1).toUpperCase(Locale.ROOT);
        if (text.contains("<!DOCTYPE") || text.contains("<!ENTITY") || text.indexOf('\0') >= 0) {
            throw FileLimits.wrong(info.getKey().getName(), "the text", "with a document type or not in UTF-8",
                "XML in UTF-8 without a document type");
        }
        return bytes;
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
