// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.files.FileLimits;

/**
 * Checks a .j3o before jMonkeyEngine's BinaryImporter reads it. The importer creates an object of any class that the
 * file names, allocates memory for any length, and leaves out objects that it can't read. The file contains the
 * classes, each with alias, versions, name and fields; then the location of each object; then the objects, each with
 * the alias of its class, its length and its fields.
 */
final class J3oCheck {
    private static final List<String> SCENE_CLASSES = List.of("com.jme3.scene.", "com.jme3.material.", "com.jme3.math.",
        "com.jme3.texture.",
        "com.jme3.bounding.", "com.jme3.animation.", "com.jme3.anim.", "com.jme3.light.", "com.jme3.shader.",
        "com.jme3.asset.",
        "com.jme3.collision.", "com.jme3.util.", "com.jme3.effect.");
    private static final int MARK = 0x4a4d4533;
    /** Newest version of the format that jMonkeyEngine 3.6 reads. */
    private static final int VERSION = 2;
    /** Bytes of an object's number and location. */
    private static final int LOCATION = 8;

    private final String file;
    private final ByteBuffer in;
    private final Map<String, J3oClass> classes = new HashMap<>();
    /** Name of the current part of the file, for errors. */
    private String what = "the head";

    J3oCheck(String file, byte[] bytes) {
        this.file = file;
        this.in = ByteBuffer.wrap(bytes);
    }

    /**
     * @throws IOException if the file is truncated, names a class that does not belong to a scene, or has a field that
     *     does not fit into its object
     */
    void check() throws IOException {
        try {
            int alias = classes();
            what = "the number of objects";
            int count = in.getInt();
            FileLimits.range(file, what, count, 1, in.remaining() / LOCATION);
            int[] places = new int[count];
            int[] numbers = new int[count];
            for (int i = 0; i < count; i++) {
                numbers[i] = in.getInt();
                places[i] = in.getInt();
            }
            what = "the number of the first object";
            in.getInt();
            in.getInt();
            int start = in.position();
            for (int i = 0; i < count; i++) {
                what = "the place of object " + numbers[i];
                FileLimits.range(file, what, places[i], 0, in.capacity() - start - alias - Integer.BYTES);
                in.limit(in.capacity()).position(start + places[i]);
                object(numbers[i], text(alias));
            }
        } catch (BufferUnderflowException e) {
            throw cutOff();
        }
    }

    private IOException cutOff() {
        return FileLimits.wrong(file, what + " at byte " + in.position(),
            "longer than the rest of its part of the file, " + in.remaining() + " bytes",
            "a whole .j3o, as jMonkeyEngine 3.6 writes it");
    }

    private int classes() throws IOException {
        int first = in.getInt();
        boolean versioned = first == MARK;
        if (versioned) {
            FileLimits.range(file, "the version of the format", in.getInt(), 1, VERSION);
        }
        int count = versioned ? in.getInt() : first;
        FileLimits.range(file, "the number of classes", count, 1, in.remaining());
        int alias = (int) (float) (Math.log(count) / Math.log(256)) + 1;
        for (int i = 0; i < count; i++) {
            what = "class " + i;
            String key = text(alias);
            if (versioned) {
                text(Integer.BYTES * Byte.toUnsignedInt(in.get()));
            }
            J3oClass made = new J3oClass(text(in.getInt()));
            if (SCENE_CLASSES.stream().noneMatch(made.name::startsWith)) {
                throw FileLimits.wrong(file, "the class of an object", made.name,
                    "a class of scenes, meshes and materials");
            }
            int fields = in.getInt();
            FileLimits.range(file, "the number of fields of " + made.name, fields, 0, 1 << Byte.SIZE);
            for (int f = 0; f < fields; f++) {
                byte number = in.get();
                made.types.put(number, in.get());
                made.names.put(number, text(in.getInt()));
            }
            classes.put(key, made);
        }
        return alias;
    }

    private String text(int length) throws IOException {
        if (length < 0 || length > in.remaining()) {
            throw cutOff();
        }
        byte[] name = new byte[length];
        in.get(name);
        return new String(name, StandardCharsets.ISO_8859_1);
    }

    private void object(int number, String alias) throws IOException {
        J3oClass of = classes.get(alias);
        if (of == null) {
            throw FileLimits.wrong(file, "the class of object " + number, alias, "one of the file's " + classes.size()
                + " classes");
        }
        what = "object " + number + ", a " + of.name + ",";
        int length = in.getInt();
        FileLimits.range(file, "the length of " + what, length, 0, in.remaining());
        in.limit(in.position() + length);
        while (in.hasRemaining()) {
            byte field = in.get();
            if (!of.types.containsKey(field)) {
                throw FileLimits.wrong(file, "a field of " + what, field, "one of the numbers " + of.types.keySet());
            }
            what = "field \"" + of.names.get(field) + "\" of object " + number + ", a " + of.name + ",";
            if (!J3oClass.skip(in, of.types.get(field))) {
                throw cutOff();
            }
            what = "object " + number + ", a " + of.name + ",";
        }
    }
}
