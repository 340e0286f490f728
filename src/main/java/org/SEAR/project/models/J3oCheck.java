package org.SEAR.project.models;

import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.SEAR.files.FileLimits;

/**
 * Checks the header of a .j3o before jMonkeyEngine's BinaryImporter reads it. The importer creates an object of any
 * class in the header, and reads past the end of the file if a count is too large. The header contains the classes,
 * each with alias, versions, name and fields, then the location of each object.
 */
final class J3oCheck {
    private static final List<String> SCENE_CLASSES = List.of("com.jme3.scene.", "com.jme3.material.", "com.jme3.math.", "com.jme3.texture.",
        "com.jme3.bounding.", "com.jme3.animation.", "com.jme3.anim.", "com.jme3.light.", "com.jme3.shader.", "com.jme3.asset.",
        "com.jme3.collision.",
        "com.jme3.util.", "com.jme3.effect.");
    private static final int MARK = 0x4a4d4533;
    /** Bytes of an object's number and location. */
    private static final int LOCATION = 8;

    private final String file;
    private final ByteBuffer in;

    J3oCheck(String file, byte[] bytes) {
        this.file = file;
        this.in = ByteBuffer.wrap(bytes);
    }

    /**
     * @throws IOException if the file is truncated, names a class that does not belong to a scene, or counts more objects
     *     than it contains
     */
    void check() throws IOException {
        try {
            classes();
            FileLimits.range(file, "the number of objects", in.getInt(), 1, in.remaining() / LOCATION);
        } catch (BufferUnderflowException | IllegalArgumentException e) {
            throw new IOException(file + " is cut off or no .j3o file", e);
        }
    }

    private void classes() throws IOException {
        int first = in.getInt();
        boolean versioned = first == MARK;
        if (versioned) {
            in.getInt();
        }
        int classes = versioned ? in.getInt() : first;
        int aliasWidth = (int) (float) (Math.log(classes) / Math.log(256)) + 1;
        for (int i = 0; i < classes; i++) {
            skip(aliasWidth);
            if (versioned) {
                skip(Integer.BYTES * Byte.toUnsignedInt(in.get()));
            }
            checkName();
            int fields = in.getInt();
            for (int f = 0; f < fields; f++) {
                in.getShort();
                skip(in.getInt());
            }
        }
    }

    private void checkName() throws IOException {
        byte[] name = new byte[Math.max(0, Math.min(in.getInt(), in.remaining()))];
        in.get(name);
        String className = new String(name, StandardCharsets.UTF_8);
        if (SCENE_CLASSES.stream().noneMatch(className::startsWith)) {
            throw new IOException(file + " contains a " + className + "; a model may only contain scenes, meshes and materials");
        }
    }

    private void skip(int count) {
        in.position(in.position() + Math.max(0, count));
    }
}
