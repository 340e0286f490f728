// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;

/**
 * Writes small files like Blender 2.79: a header, blocks of structures that refer to each other by their former memory
 * addresses, and a description of the structures (DNA1). Little-endian, 64-bit pointers.
 */
final class BlendFile {
    private static final String HEADER = "BLENDER-v279";
    private static final int POINTER = 8;
    private static final long FIRST_ADDRESS = 0x10000;
    private static final Map<String, Integer> SIMPLE = new LinkedHashMap<>();
    /** One structure per line: its name, then type and name of each field. */
    private static final String[] STRUCTURES = {
        "ListBase void *first void *last",
        "ID void *next void *prev void *newid void *lib char name[66] short us int flag void *properties",
        "CustomDataLayer int type int active int uid int flag char name[64] void *data",
        "CustomData CustomDataLayer *layers int totlayer int maxlayer",
        "MVert float co[3] short no[3] char flag char bweight",
        "MEdge int v1 int v2 char crease char bweight short flag",
        "MLoop int v int e",
        "MPoly int loopstart int totloop short mat_nr char flag char pad",
        "Mesh ID id void **mat MPoly *mpoly MLoop *mloop void *mface MVert *mvert MEdge *medge void *dvert void *mcol "
        + "void *mloopcol CustomData fdata CustomData ldata int totvert int totedge int totloop int totpoly",
        "Object ID id short type char restrictflag char pad int lay void *parent void *data void *action void *pose "
            + "float size[3] float obmat[4][4] int pad2 ListBase modifiers ListBase defbase ListBase constraints",
        "Base Base *next Base *prev Object *object",
        "Scene ID id ListBase base",
        "ModifierData ModifierData *next ModifierData *prev int type int mode int stackindex int pad char name[64] "
        + "void *scene char *error",
        "SubsurfModifierData ModifierData modifier short subdivType short levels short renderLevels short flags",
        "ArrayModifierData ModifierData modifier void *start_cap void *end_cap void *curve_ob void *offset_ob "
        + "float offset[3] float scale[3]"
            + " float length float merge_dist int fit_type int offset_type int flags int count",
        "BevelModifierData ModifierData modifier float value int res",
        "Library ID id void *idblock char name[240] char filepath[240]"};

    static {
        SIMPLE.put("char", 1);
        SIMPLE.put("short", 2);
        SIMPLE.put("int", 4);
        SIMPLE.put("float", 4);
        SIMPLE.put("void", 0);
    }

    private final Map<String, Map<String, Integer>> offsets = new LinkedHashMap<>();
    private final Map<String, Integer> sizes = new LinkedHashMap<>(SIMPLE);
    private final List<Block> blocks = new ArrayList<>();
    private long nextAddress = FIRST_ADDRESS;

    private BlendFile() {
        for (String line : STRUCTURES) {
            String[] words = line.split(" ");
            Map<String, Integer> fields = new LinkedHashMap<>();
            int offset = 0;
            for (int i = 1; i < words.length; i += 2) {
                fields.put(words[i + 1].replaceAll("\\*|\\[.*", ""), offset);
                offset += (words[i + 1].startsWith("*") ? POINTER : sizes.get(words[i])) * entries(words[i + 1]);
            }
            offsets.put(words[0], fields);
            sizes.put(words[0], offset);
        }
    }

    private static int entries(String field) {
        int entries = 1;
        String[] parts = field.split("[\\[\\]]+");
        for (int i = 1; i < parts.length; i++) {
            entries *= Integer.parseInt(parts[i]);
        }
        return entries;
    }

    /**
     * Makes a scene with one object, a mesh of polygons.
     * @param corners x, y, z of each vertex in Blender's frame: z up, y forward
     * @param polygons the vertex numbers of each polygon
     * @param place position of the object in Blender's frame
     */
    static byte[] mesh(float[] corners, int[][] polygons, float[] place) {
        BlendFile file = new BlendFile();
        return file.scene(file.meshBlock(corners, polygons), place);
    }

    /**
     * Makes a mesh that is turned by 45 degrees about Blender's z axis in a parent that is twice as long along x.
     * Blender stores the product of both matrices, which shears.
     */
    static byte[] sheared(float[] corners, int[][] polygons) {
        BlendFile file = new BlendFile();
        Block mesh = file.meshBlock(corners, polygons);
        float half = (float) Math.sqrt(0.5);
        Block parent = file.object("OBparent", 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
        Block child = file.object("OBsolid", 1, mesh.address, 2 * half, half, 0, 0, -2 * half, half, 0, 0, 0, 0, 1, 0,
            0, 0, 0, 1);
        child.at(0, "parent").putLong(parent.address);
        return file.scene(parent, child);
    }

    /**
     * Makes a mesh with a modifier.
     *
     * @param type type of the modifier without its ending
     * @param number subdivision levels or number of copies, each 1 m further along x
     */
    static byte[] modified(float[] corners, int[][] polygons, String type, int number) {
        BlendFile file = new BlendFile();
        Block mesh = file.meshBlock(corners, polygons);
        Block modifier = file.block("DATA", type + "ModifierData", 1);
        if (type.equals("Subsurf")) {
            modifier.at(0, "subdivType").putShort((short) 1).putShort((short) number);
        } else if (type.equals("Array")) {
            modifier.at(0, "offset").putFloat(1);
            modifier.at(0, "offset_type").putInt(1);
            modifier.at(0, "count").putInt(number);
        }
        Block object = file.object("OBsolid", 1, mesh.address, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
        object.at(0, "modifiers").putLong(modifier.address).putLong(modifier.address);
        return file.scene(object);
    }

    private Block object(String name, int type, long data, float... matrix) {
        Block object = block("OB", "Object", 1).name(name);
        object.at(0, "type").putShort((short) type);
        object.at(0, "lay").putInt(1);
        object.at(0, "data").putLong(data);
        object.at(0, "size").putFloat(1).putFloat(1).putFloat(1);
        ByteBuffer to = object.at(0, "obmat");
        for (float value : matrix) {
            to.putFloat(value);
        }
        return object;
    }

    private byte[] scene(Block... objects) {
        Block bases = block("DATA", "Base", 1);
        Block last = bases;
        last.at(0, "object").putLong(objects[0].address);
        for (int i = 1; i < objects.length; i++) {
            Block next = block("DATA", "Base", 1);
            next.at(0, "object").putLong(objects[i].address);
            last.at(0, "next").putLong(next.address);
            last = next;
        }
        Block scene = block("SC", "Scene", 1).name("SCscene");
        scene.at(0, "base").putLong(bases.address).putLong(last.address);
        return bytes();
    }

    /**
     * Makes the same object with its mesh in another file.
     * @param path of that file, as Blender writes it
     */
    static byte[] linked(String path) {
        BlendFile file = new BlendFile();
        Block library = file.block("LI", "Library", 1).name("LIother");
        library.at(0, "name").put(path.getBytes(StandardCharsets.UTF_8));
        library.at(0, "filepath").put(path.getBytes(StandardCharsets.UTF_8));
        Block mesh = file.block("ID", "ID", 1);
        mesh.at(0, "lib").putLong(library.address);
        mesh.at(0, "name").put("MEsolid".getBytes(StandardCharsets.US_ASCII));
        return file.scene(mesh, new float[3]);
    }

    private byte[] scene(Block mesh, float[] place) {
        return scene(object("OBsolid", 1, mesh.address, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, place[0], place[1],
            place[2], 1));
    }

    private Block meshBlock(float[] corners, int[][] polygons) {
        Block vertices = block("DATA", "MVert", corners.length / 3);
        for (int i = 0; i < corners.length; i++) {
            vertices.at(i / 3, "co").putFloat(vertices.bytes.position() + i % 3 * 4, corners[i]);
        }
        int corner = 0;
        Block polys = block("DATA", "MPoly", polygons.length);
        for (int i = 0; i < polygons.length; i++) {
            polys.at(i, "loopstart").putInt(corner).putInt(polygons[i].length);
            corner += polygons[i].length;
        }
        Block loops = block("DATA", "MLoop", corner);
        corner = 0;
        for (int[] polygon : polygons) {
            for (int vertex : polygon) {
                loops.at(corner++, "v").putInt(vertex);
            }
        }
        TreeSet<Long> pairs = new TreeSet<>();
        for (int[] polygon : polygons) {
            for (int i = 0; i < polygon.length; i++) {
                int other = polygon[(i + 1) % polygon.length];
                pairs.add((long) Math.min(polygon[i], other) << 32 | Math.max(polygon[i], other));
            }
        }
        Block edges = block("DATA", "MEdge", pairs.size());
        int edge = 0;
        for (long pair : pairs) {
            edges.at(edge++, "v1").putInt((int) (pair >> 32)).putInt((int) pair);
        }
        Block layers = block("DATA", "CustomDataLayer", 1);
        Block mesh = block("ME", "Mesh", 1).name("MEsolid");
        mesh.at(0, "mvert").putLong(vertices.address);
        mesh.at(0, "mpoly").putLong(polys.address);
        mesh.at(0, "medge").putLong(edges.address);
        mesh.at(0, "mloop").putLong(loops.address);
        mesh.at(0, "ldata").putLong(layers.address).putInt(1).putInt(1);
        mesh.at(0, "totvert").putInt(corners.length / 3).putInt(pairs.size()).putInt(corner).putInt(polygons.length);
        return mesh;
    }

    private Block block(String code, String type, int count) {
        Block block = new Block(code, type, count, nextAddress);
        nextAddress += block.bytes.capacity() + 16 - block.bytes.capacity() % 16;
        blocks.add(block);
        return block;
    }

    private byte[] bytes() {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(HEADER.getBytes(StandardCharsets.US_ASCII));
        List<String> structures = new ArrayList<>(offsets.keySet());
        blocks.forEach(block -> write(out, block.code, block.address, structures.indexOf(block.type), block.count,
            block.bytes.array()));
        write(out, "DNA1", 0, 0, 1, description());
        write(out, "ENDB", 0, 0, 0, new byte[0]);
        return out.toByteArray();
    }

    private static void write(ByteArrayOutputStream out, String code, long address, int structure, int count,
        byte[] data) {
        int size = (data.length + 3) / 4 * 4;
        ByteBuffer block = little(24 + size);
        block.put(code.getBytes(StandardCharsets.US_ASCII)).position(4);
        block.putInt(size).putLong(address).putInt(structure).putInt(count).put(data);
        out.writeBytes(block.array());
    }

    private static ByteBuffer little(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }

    private byte[] description() {
        List<String> names = new ArrayList<>();
        List<String> types = new ArrayList<>(sizes.keySet());
        for (String line : STRUCTURES) {
            String[] words = line.split(" ");
            for (int i = 2; i < words.length; i += 2) {
                names.add(words[i]);
            }
        }
        names = new ArrayList<>(new TreeSet<>(names));
        ByteBuffer out = little(1 << 14);
        out.put("SDNA".getBytes(StandardCharsets.US_ASCII));
        words(out, "NAME", names);
        words(out, "TYPE", types);
        out.put("TLEN".getBytes(StandardCharsets.US_ASCII));
        types.forEach(type -> out.putShort(sizes.get(type).shortValue()));
        align(out);
        out.put("STRC".getBytes(StandardCharsets.US_ASCII)).putInt(STRUCTURES.length);
        for (String line : STRUCTURES) {
            String[] words = line.split(" ");
            out.putShort((short) types.indexOf(words[0])).putShort((short) (words.length / 2));
            for (int i = 1; i < words.length; i += 2) {
                out.putShort((short) types.indexOf(words[i])).putShort((short) names.indexOf(words[i + 1]));
            }
        }
        byte[] used = new byte[out.position()];
        out.rewind();
        out.get(used);
        return used;
    }

    private static void words(ByteBuffer out, String mark, List<String> words) {
        out.put(mark.getBytes(StandardCharsets.US_ASCII)).putInt(words.size());
        words.forEach(word -> out.put(word.getBytes(StandardCharsets.US_ASCII)).put((byte) 0));
        align(out);
    }

    private static void align(ByteBuffer out) {
        out.put(new byte[(4 - out.position() % 4) % 4]);
    }

    /** Consecutive structures of one type. */
    private final class Block {
        private final String code;
        private final String type;
        private final int count;
        private final long address;
        private final ByteBuffer bytes;

        Block(String code, String type, int count, long address) {
            this.code = code;
            this.type = type;
            this.count = count;
            this.address = address;
            this.bytes = little(sizes.get(type) * count);
        }

        /** Returns the bytes from a field on. */
        ByteBuffer at(int index, String field) {
            bytes.position(index * sizes.get(type) + offsets.get(type).get(field));
            return bytes;
        }

        /** Names a structure that starts with an ID. */
        Block name(String name) {
            bytes.position(offsets.get("ID").get("name"));
            bytes.put(name.getBytes(StandardCharsets.US_ASCII));
            return this;
        }
    }
}
