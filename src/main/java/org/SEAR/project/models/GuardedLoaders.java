package org.SEAR.project.models;

import com.jme3.asset.AssetInfo;
import com.jme3.asset.AssetManager;
import com.jme3.export.binary.BinaryLoader;
import com.jme3.scene.plugins.blender.BlenderContext;
import com.jme3.scene.plugins.blender.BlenderLoader;
import com.jme3.scene.plugins.blender.file.BlenderFileException;
import com.jme3.scene.plugins.blender.file.FileBlockHeader;
import com.jme3.scene.plugins.blender.file.Structure;
import com.jme3.scene.plugins.ogre.MeshLoader;
import com.jme3.scene.plugins.ogre.SceneLoader;
import com.jme3.scene.plugins.ogre.SkeletonLoader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;

/**
 * jMonkeyEngine's loaders trust their files: OGRE XML may read other files through entities, a .j3o names the Java classes to be made, a
 * .blend links to files anywhere. A shared project must not be able to do any of this, so these look first.
 */
final class GuardedLoaders {
    private static final List<String> SCENE_CLASSES = List.of("com.jme3.scene.", "com.jme3.material.", "com.jme3.math.", "com.jme3.texture.",
        "com.jme3.bounding.", "com.jme3.animation.", "com.jme3.anim.", "com.jme3.light.", "com.jme3.shader.", "com.jme3.asset.",
        "com.jme3.collision.",
        "com.jme3.util.", "com.jme3.effect.");
    private static final int J3O_MARK = 0x4a4d4533;

    private GuardedLoaders() {
    }

    /** Puts them in the place of the unguarded ones. */
    static void register(AssetManager manager) {
        manager.unregisterLoader(SceneLoader.class);
        manager.registerLoader(Mesh.class, "meshxml", "mesh.xml");
        manager.registerLoader(Skeleton.class, "skeletonxml", "skeleton.xml");
        manager.registerLoader(Binary.class, "j3o", "j3f");
        manager.registerLoader(Blend.class, "blend");
    }

    /** OGRE meshes without document type. */
    public static final class Mesh extends MeshLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return super.load(xml(info));
        }
    }

    /** OGRE skeletons without document type. */
    public static final class Skeleton extends SkeletonLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            return super.load(xml(info));
        }
    }

    /** jMonkeyEngine's own format, with classes of scenes only. */
    public static final class Binary extends BinaryLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            byte[] bytes = bytes(info);
            try {
                checkClasses(ByteBuffer.wrap(bytes), info.getKey().getName());
            } catch (BufferUnderflowException | IllegalArgumentException e) {
                throw new IOException(info.getKey().getName() + " is cut off or no .j3o file", e);
            }
            return super.load(new Checked(info, bytes));
        }
    }

    /** Blender files that link to no others, which may lie anywhere on the disk. */
    public static final class Blend extends BlenderLoader {
        /** The structure that holds the path of another file; jMonkeyEngine does not know its block's code. */
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
            // the locator of linked files is gone already
        }
    }

    private static AssetInfo xml(AssetInfo info) throws IOException {
        byte[] bytes = bytes(info);
        String text = new String(bytes, StandardCharsets.ISO_8859_1).toUpperCase(Locale.ROOT);
        if (text.contains("<!DOCTYPE") || text.contains("<!ENTITY") || text.indexOf('\0') >= 0) {
            throw new IOException(info.getKey().getName() + " has a document type or is not in UTF-8, which is not allowed in a model");
        }
        return new Checked(info, bytes);
    }

    private static byte[] bytes(AssetInfo info) throws IOException {
        try (InputStream in = info.openStream()) {
            return in.readAllBytes();
        }
    }

    /** The head of the file: for each class an alias, versions, its name and fields (as jMonkeyEngine's BinaryImporter reads it). */
    private static void checkClasses(ByteBuffer in, String file) throws IOException {
        int first = in.getInt();
        boolean versioned = first == J3O_MARK;
        if (versioned) {
            in.getInt();
        }
        int classes = versioned ? in.getInt() : first;
        int aliasWidth = (int) (Math.log(classes) / Math.log(256)) + 1;
        for (int i = 0; i < classes; i++) {
            skip(in, aliasWidth);
            if (versioned) {
                skip(in, 4 * Byte.toUnsignedInt(in.get()));
            }
            byte[] name = new byte[Math.min(in.getInt(), in.remaining())];
            in.get(name);
            String className = new String(name, StandardCharsets.UTF_8);
            if (SCENE_CLASSES.stream().noneMatch(className::startsWith)) {
                throw new IOException(file + " wants a " + className + "; a model may hold scenes, meshes and materials only");
            }
            int fields = in.getInt();
            for (int f = 0; f < fields; f++) {
                in.getShort();
                skip(in, in.getInt());
            }
        }
    }

    private static void skip(ByteBuffer in, int count) {
        in.position(in.position() + Math.max(0, count));
    }

    /** A file that was looked through. */
    private static final class Checked extends AssetInfo {
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
