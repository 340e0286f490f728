// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import com.jme3.export.binary.BinaryExporter;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;
import com.jme3.scene.VertexBuffer;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.GZIPOutputStream;

/** Models and pictures with one error each, and their messages. */
public final class BrokenModels {
    static final ModelFiles TRIANGLE = new ModelFiles(new float[] {0, 0, 0, 1, 0, 0, 0, 2, 0},
        new int[] {0, 1, 2}, 1, 0, -3);

    /** File content by file name. */
    public final Map<String, byte[]> files = new LinkedHashMap<>();
    /** Part of the message by file name. */
    public final Map<String, String> messages = new LinkedHashMap<>();

    /** Returns broken models. */
    public static BrokenModels models() throws IOException {
        BrokenModels all = new BrokenModels();
        all.obj();
        all.gltfNodes();
        all.gltfBuffers();
        all.gltfMeshes();
        all.glb();
        all.ogre();
        all.j3o();
        all.blend();
        all.parts();
        return all;
    }

    private void parts() throws IOException {
        byte[] stl = TRIANGLE.bytes(".stl");
        put("cut.stl", Arrays.copyOf(stl, stl.length - 1), "the file's size is 133 bytes, legal: 134 bytes for the 1 ");
        put("nan.stl", StlFormatTest.TEXT.replace("1e0", "NaN"), "a coordinate in line 6 is nan, legal: a number");
        byte[] ply = TRIANGLE.bytes(".ply");
        put("cut.ply", Arrays.copyOf(ply, ply.length - 1), "face 1 is missing, legal: all elements that the head ");
        put("cloud.ply", PlyFormatTest.PAINTED.split("element edge")[0] + "end_header\n0 0 0 1 1 1\n1 0 0 1 1 1\n"
            + "1 1 0 1 1 1\n2 2 2 1 1 1\n", "the number of triangles is 0: it has no triangles");
        put("entity.dae", "<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/passwd'>]>" + ColladaFormatTest.PAINTED,
            "the text is with a document type or not in UTF-8, legal: XML in UTF-8 without a document type");
        put("index.dae", ColladaFormatTest.PAINTED.replace("6 7 0", "6 8 0"), "an index of <p> in line 1 is 8");
    }

    /** Returns broken pictures. */
    public static BrokenModels pictures() throws IOException {
        BrokenModels all = new BrokenModels();
        all.hugePictures();
        return all;
    }

    private void put(String name, String content, String message) {
        put(name, content.getBytes(StandardCharsets.UTF_8), message);
    }

    private void put(String name, byte[] content, String message) {
        if (files.put(name, content) != null) {
            throw new IllegalArgumentException(name + " is there twice");
        }
        messages.put(name, message);
    }

    private static String star(int corners) {
        StringBuilder text = new StringBuilder();
        StringBuilder face = new StringBuilder("f");
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            double radius = 1 + i % 2;
            text.append("v ").append(radius * Math.cos(angle)).append(" 0 ").append(radius * Math.sin(angle))
                .append('\n');
            face.append(' ').append(i + 1);
        }
        return text.append(face).append('\n').toString();
    }

    private void obj() {
        String far = "legal: a finite number up to 1000000 m";
        put("nan.obj", "v NaN 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n",
            "a coordinate of v 1 in the face in line 5 is NaN, " + far);
        put("infinite.obj", "v 0 0 0\nv Infinity 0 0\nv 0 1 0\nf 1 2 3\n", far);
        put("minus-infinite.obj", "v 0 0 0\nv 0 -Infinity 0\nv 0 1 0\nf 1 2 3\n", far);
        put("far.obj", "v 0 0 0\nv 1e30 0 0\nv 0 1 0\nf 1 2 3\n", "is 1.0E30, " + far);
        put("too-far-for-a-float.obj", "v 0 0 0\nv 1e99 0 0\nv 0 1 0\nf 1 2 3\n", far);
        put("no-such-vertex.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n",
            "a corner of the face in line 4 is 9, legal: the number of a v line before it, 1 to 3");
        put("vertex-zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "a corner of the face in line 4 is 0");
        put("words.obj", "v a b c\nf 1 2 3\n", "line 1 is v a b c, legal: v and three numbers");
        put("short-vertex.obj", "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1 is v 0 0, legal");
        put("no-faces.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no triangles");
        put("empty.obj", "", "the file's size is 0");
        put("face-first.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "line 1 is 1, legal: none, for there is no v "
            + "line before it");
        put("commas.obj", "v 0 0 0\nv 1,5 0 0\nv 0 1 0\nf 1 2 3\n", "line 2 is v 1,5 0 0, legal: v and three numbers "
            + "with decimal points");
        put("no-such-place.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/2\n",
            "a corner of the face in line 5 is 3/2, legal: the number of a vt line before it, 1 to 1");
        put("no-normals.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\n", "line 4 is 1//1, legal: none, for there "
            + "is no vn line before it");
        put("star.obj", star(1200),
            "the number of corners of the face in line 1201, which is not convex, is 1200, legal: 3 to 1000");
    }

    private static String gltf(String... change) throws IOException {
        String text = new String(TRIANGLE.bytes(".gltf"), StandardCharsets.UTF_8);
        for (int i = 0; i < change.length; i += 2) {
            if (!text.contains(change[i])) {
                throw new IllegalArgumentException(change[i] + " is not in " + text);
            }
            text = text.replace(change[i], change[i + 1]);
        }
        return text;
    }

    private void gltfNodes() throws IOException {
        String nodes = "\"nodes\":[{\"mesh\":0";
        put("cycle.gltf", gltf(nodes, "\"nodes\":[{\"children\":[0],\"mesh\":0"),
            "nodes[0] is nested without end or too deep");
        put("cycle-of-two.gltf", gltf(nodes, "\"nodes\":[{\"children\":[1]},{\"children\":[0],\"mesh\":0"),
            "nested without end or too deep");
        put("two-parents.gltf", gltf(nodes, "\"nodes\":[{\"children\":[2,1]},{\"children\":[2]},{\"mesh\":0"),
            "nodes[1].children is 2, legal: a node that has no other parent");
        put("child-twice.gltf", gltf(nodes, "\"nodes\":[{\"children\":[1,1]},{\"mesh\":0"),
            "nodes[0].children is 1, legal: a node that has no other");
        StringBuilder doubling = new StringBuilder("\"nodes\":[");
        StringBuilder deep = new StringBuilder("\"nodes\":[");
        for (int i = 1; i <= 200; i++) {
            doubling.append("{\"children\":[" + i + "," + i + "]},");
            deep.append("{\"children\":[" + i + "]},");
        }
        put("doubling.gltf", gltf(nodes, doubling + "{\"mesh\":0"), "a node that has no other parent");
        put("deep.gltf", gltf(nodes, deep + "{\"mesh\":0"), "nested without end or too deep, legal: a tree at "
            + "most 100 deep");
        put("many-nodes.gltf", gltf(nodes, "\"nodes\":[" + "{},".repeat(10_000) + "{\"mesh\":0"),
            "the number of nodes is 10001, legal: 0 to 10000");
        put("no-such-child.gltf", gltf(nodes, "\"nodes\":[{\"children\":[7],\"mesh\":0"),
            "nodes[0].children is 7, legal: 0 to 0");
        put("no-such-mesh.gltf", gltf(nodes, "\"nodes\":[{\"mesh\":3"), "nodes[0].mesh is 3, legal: 0 to 0");
        put("no-such-node.gltf", gltf("\"scenes\":[{\"nodes\":[0]", "\"scenes\":[{\"nodes\":[4]"),
            "scenes[0].nodes is 4, legal: 0 to 0");
        put("shown-twice.gltf", gltf("\"scenes\":[{\"nodes\":[0]", "\"scenes\":[{\"nodes\":[0,0]"),
            "at most once in a scene");
        put("no-such-scene.gltf", gltf("\"scene\":0", "\"scene\":-1"), "scene is -1, legal: 0 to 0");
        put("nan-place.gltf", gltf("\"translation\":[1.0", "\"translation\":[\"NaN\""), "legal: a finite number");
        put("far-place.gltf", gltf("\"translation\":[1.0", "\"translation\":[1e12"), "legal: a finite number");
        put("text-for-a-list.gltf", gltf("\"nodes\":[0]", "\"nodes\":\"0\""),
            "scenes[0].nodes is \"0\", legal: a list");
    }

    private void gltfBuffers() throws IOException {
        put("long-buffer.gltf", gltf("\"byteLength\":48}", "\"byteLength\":2000000000}"),
            "buffers[0].byteLength is 2000000000, legal: 0 to 48");
        put("negative-buffer.gltf", gltf("\"byteLength\":48}", "\"byteLength\":-1}"), "buffers[0].byteLength is -1");
        put("short-buffer.gltf", gltf("\"byteLength\":48}", "\"byteLength\":40}"),
            "bufferViews[1].byteLength is 12, legal: 0 to 4");
        put("missing-file.gltf", gltf("data:application/octet-stream;base64,", "nothere.bin?"),
            "a buffer's uri is nothere.bin?");
        put("no-data.gltf", gltf("data:application/octet-stream;base64,", "data:"), "buffers[0].uri");
        put("no-such-buffer.gltf", gltf("{\"buffer\":0,\"byteLength\"", "{\"buffer\":5,\"byteLength\""),
            "bufferViews[0].buffer is 5, legal: 0 to 0");
        put("view-behind-the-end.gltf", gltf("\"byteOffset\":36", "\"byteOffset\":4000"),
            "bufferViews[1].byteOffset is 4000, legal: a whole number from 0 to 48");
        put("many-elements.gltf", gltf("\"count\":3,\"type\":\"VEC3\"", "\"count\":2000000000,\"type\":\"VEC3\""),
            "accessors[0].count is 2000000000, legal: 1 to 12000000");
        put("more-elements-than-bytes.gltf", gltf("\"count\":3,\"type\":\"VEC3\"", "\"count\":4,\"type\":\"VEC3\""),
            "accessors[0].count is 4, legal: 1 to 3");
        put("no-such-view.gltf", gltf("{\"bufferView\":1", "{\"bufferView\":9"),
            "accessors[1].bufferView is 9, legal: 0 to 1");
        put("odd-component.gltf", gltf("\"componentType\":5125", "\"componentType\":1"), "accessors[1] is");
        put("odd-type.gltf", gltf("\"type\":\"VEC3\"", "\"type\":\"VEC9\""), "accessors[0] is");
    }

    private void gltfMeshes() throws IOException {
        put("no-such-accessor.gltf", gltf("\"indices\":1", "\"indices\":8"),
            "meshes[0].primitives[0].indices is 8, legal: 0 to 1");
        put("no-such-positions.gltf", gltf("\"POSITION\":0", "\"POSITION\":8"),
            "meshes[0].primitives[0].attributes.POSITION is 8, legal: 0 to 1");
        put("no-attributes.gltf", gltf("\"attributes\":{\"POSITION\":0},", ""),
            "meshes[0].primitives[0].attributes is missing, legal: a JSON object");
        String material = "\"asset\"";
        for (String packed : new String[] {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
            put(packed + ".gltf", gltf(material, "\"extensionsRequired\":[\"" + packed + "\"],\"asset\""),
                "a required extension is " + packed
                + ", legal: one of KHR_lights_punctual, KHR_materials_pbrSpecularGlossiness, KHR_materials_unlit,"
                + " KHR_mesh_quantization, KHR_texture_transform: export it without compression");
        }
        put("no-such-image.gltf", gltf(
            material, "\"images\":[{\"uri\":\"a.png\"}],\"textures\":[{\"source\":1}],\"asset\""),
            "textures[0].source is 1, legal: 0 to 0");
        put("image-in-no-view.gltf", gltf(material, "\"images\":[{\"bufferView\":7}],\"asset\""),
            "images[0].bufferView is 7, legal: 0 to 1");
        put("no-such-sampler.gltf", gltf(
            material, "\"animations\":[{\"channels\":[{\"sampler\":2,\"target\":{}}]}],\"asset\""),
            "animations[0].channels.sampler is 2, legal: nothing");
        put("moves-nothing.gltf", gltf(
            material, "\"animations\":[{\"channels\":[{\"sampler\":0}],\"samplers\":[{}]}],\"asset\""),
            "animations[0].channels.target is missing, legal: a JSON object");
        put("no-such-moved-node.gltf",
            gltf(material, "\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":9}}],"
                + "\"samplers\":[{}]}],\"asset\""), "animations[0].channels.target.node is 9, legal: 0 to 0");
        put("no-such-keys.gltf", gltf(
            material, "\"animations\":[{\"samplers\":[{\"input\":0,\"output\":9}]}],\"asset\""),
            "animations[0].samplers.output is 9, legal: 0 to 1");
        put("no-such-target.gltf", gltf("\"indices\":1", "\"targets\":[{\"POSITION\":8}],\"indices\":1"),
            "meshes[0].primitives[0].targets[0].POSITION is 8, legal: 0 to 1");
        put("short-place.gltf", gltf("\"translation\":[", "\"scale\":[1,1],\"translation\":["),
            "the number of numbers of nodes[0].scale is 2, legal: 3");
        put("no-meshes.gltf", gltf("\"meshes\"", "\"nothing\""), "nodes[0].mesh is 0, legal: nothing, because "
            + "there are none");
        put("list.gltf", "[]", "the text is [], legal: a JSON object");
        put("nested.gltf", "[".repeat(100_000), "can't be loaded");
        put("index-out-of-range.gltf", new String(
            new ModelFiles(new float[] {0, 0, 0, 1, 0, 0, 0, 2, 0}, new int[] {0, 1, 7}, 0, 0, 0).bytes(".gltf"),
            StandardCharsets.UTF_8), "meshes[0].primitives[0].indices[2], an index of the file, is 7, legal: 0 to 2");
        put("nan.gltf", new String(new ModelFiles(new float[] {0, 0, 0, 1, 0, 0, 0, Float.NaN, 0}, new int[] {0, 1, 2},
            0, 0, 0).bytes(".gltf"), StandardCharsets.UTF_8).replace("NaN", "0"), "a coordinate of vertex 2");
    }

    private void glb() throws IOException {
        byte[] good = TRIANGLE.bytes(".glb");
        put("cut.glb", Arrays.copyOf(good, good.length / 2), "the length in the head");
        put("head-only.glb", Arrays.copyOf(good, 12), "the file's size is 12");
        put("long-json.glb", with(good, 12, 2_000_000_000), "the length of the JSON is 2000000000");
        put("negative-json.glb", with(good, 12, -5), "the length of the JSON is -5");
        put("another-version.glb", with(good, 4, 1), "a .glb of glTF 2");
        put("long-chunk.glb", with(good, good.length - 56, 2_000_000_000), "the length of a chunk is 2000000000");
    }

    private static byte[] with(byte[] bytes, int at, int value) {
        byte[] changed = bytes.clone();
        ByteBuffer.wrap(changed).order(ByteOrder.LITTLE_ENDIAN).putInt(at, value);
        return changed;
    }

    private void ogre() throws IOException {
        String good = new String(TRIANGLE.bytes(".mesh.xml"), StandardCharsets.UTF_8);
        put("many-vertices.mesh.xml", good.replace("vertexcount=\"3\"", "vertexcount=\"1000000000\""),
            "vertexcount of <geometry> in line 1 is 1000000000, legal: a whole number from 0 to 4000000");
        put("many-faces.mesh.xml", good.replace("faces count=\"1\"", "faces count=\"200000000\""),
            "count of <faces> in line 1 is 200000000, legal: a whole number from 0 to 12000000");
        put("index.mesh.xml", good.replace("v3=\"2\"", "v3=\"900\""),
            "corner 3 of the submesh in line 1 is 900, legal: 0 to 2");
        put("nan.mesh.xml", good.replace("x=\"1.0\"", "x=\"NaN\""), "a coordinate of vertex 0");
        put("not-closed.mesh.xml", good.substring(0, good.length() - 20), "can't be loaded");
        put("nothing.mesh.xml", "<mesh/>", "");
        put("another.mesh.xml", "<html><body/></html>", "");
    }

    /** Changes the number of objects, which follows the list of classes. */
    private static byte[] withObjects(byte[] j3o, int count) {
        ByteBuffer in = ByteBuffer.wrap(j3o.clone());
        in.position(8);
        for (int classes = in.getInt(); classes > 0; classes--) {
            in.get();
            skip(in, 4 * in.get());
            skip(in, in.getInt());
            for (int fields = in.getInt(); fields > 0; fields--) {
                in.getShort();
                skip(in, in.getInt());
            }
        }
        return in.putInt(count).array();
    }

    private static void skip(ByteBuffer in, int count) {
        in.position(in.position() + count);
    }

    private void j3o() throws IOException {
        Mesh mesh = new Mesh();
        mesh.setBuffer(VertexBuffer.Type.Position, 3, new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0});
        mesh.setBuffer(VertexBuffer.Type.Index, 3, new int[] {0, 1, 77});
        put("index.j3o", saved(new Geometry("solid", mesh)), "an index of \"solid\" is 77, legal: 0 to 2");
        mesh.setBuffer(VertexBuffer.Type.Index, 3, new int[] {0, 1, -1});
        put("negative-index.j3o", saved(new Geometry("solid", mesh)), "an index of \"solid\" is -1");
        put("no-mesh.j3o", saved(new Geometry("solid")), "the mesh of \"solid\" is missing");
        Node many = new Node("many");
        for (int i = 0; i < 10_001; i++) {
            many.attachChild(new Node());
        }
        put("many-nodes.j3o", saved(many), "the number of nodes is 10001");
        byte[] good = TRIANGLE.bytes(".j3o");
        put("cut.j3o", Arrays.copyOf(good, good.length * 2 / 3), "can't be loaded");
        put("head-only.j3o", Arrays.copyOf(good, 8), "can't be loaded");
        put("more-objects-than-bytes.j3o", withObjects(good, Integer.MAX_VALUE),
            "the number of objects is 2147483647, legal: 1 to ");
        put("no-objects.j3o", withObjects(good, 0), "the number of objects is 0, legal: 1 to ");
    }

    private static byte[] saved(com.jme3.scene.Spatial scene) throws IOException {
        Node root = new Node("root");
        root.attachChild(scene);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        BinaryExporter.getInstance().save(root, out);
        return out.toByteArray();
    }

    private void blend() throws IOException {
        ByteArrayOutputStream bomb = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(bomb)) {
            byte[] zeros = new byte[1 << 20];
            for (int i = 0; i < 200; i++) {
                out.write(zeros);
            }
        }
        put("bomb.blend", bomb.toByteArray(), "the unpacked size is more than 67108864");
        byte[] good = TRIANGLE.bytes(".blend");
        put("cut.blend", Arrays.copyOf(good, good.length / 2), "can't be loaded");
        put("cut-gzip.blend", Arrays.copyOf(bomb.toByteArray(), 1000), "can't be loaded");
    }

    private void hugePictures() throws IOException {
        String size = "legal: at most 32000000 pixels";
        put("huge.png", png(30_000, 20_000), "the picture's size is 30000 x 20000, " + size);
        put("wide.png", png(Integer.MAX_VALUE, 1), size);
        put("huge.gif", gif(), "the picture's size is 65535 x 65535, " + size);
        put("huge.bmp", bmp(), "the picture's size is 12000 x 8000, " + size);
        put("huge.jpg", jpeg(), "the picture's size is 65500 x 65500, " + size);
        byte[] tga = new byte[18];
        tga[2] = 2;
        ByteBuffer.wrap(tga).order(ByteOrder.LITTLE_ENDIAN).putShort(12, (short) 60_000).putShort(14, (short) 60_000);
        put("huge.tga", tga, "the picture's size is 60000 x 60000, " + size);
        byte[] dds = new byte[128];
        ByteBuffer.wrap(dds).order(ByteOrder.LITTLE_ENDIAN).putInt(12, 1 << 20).putInt(16, 1 << 20);
        put("huge.dds", dds, "the picture's size is 1048576 x 1048576, " + size);
        byte[] deep = new byte[128];
        ByteBuffer.wrap(deep).order(ByteOrder.LITTLE_ENDIAN).putInt(12, 8).putInt(16, 8).putInt(24, 1 << 20);
        put("deep.dds", deep, "the depth is 1048576, legal: 0 to 8");
        put("huge.hdr", "#?RADIANCE\n\n-Y 90000 +X 90000\n", "the picture's size is 90000 x 90000, " + size);
        put("sizeless.hdr", "#?RADIANCE\n", "without a size");
        put("short.tga", "short", "the file's size is 5, legal: 18 to");
        put("empty.png", "", "the file's size is 0, legal: 1 to");
    }

    /** Returns a PNG with rows of zeros, so that some kilobytes hold any number of pixels. */
    static byte[] png(int width, int height) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
        chunk(out, "IHDR", ByteBuffer.allocate(13).putInt(width).putInt(height).put((byte) 8).put((byte) 2).array());
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DeflaterOutputStream rows = new DeflaterOutputStream(packed)) {
            rows.write(new byte[1 << 16]);
        }
        chunk(out, "IDAT", packed.toByteArray());
        chunk(out, "IEND", new byte[0]);
        return out.toByteArray();
    }

    private static void chunk(ByteArrayOutputStream out, String kind, byte[] data) throws IOException {
        byte[] name = kind.getBytes(StandardCharsets.US_ASCII);
        CRC32 crc = new CRC32();
        crc.update(name);
        crc.update(data);
        out.write(ByteBuffer.allocate(4).putInt(data.length).array());
        out.write(name);
        out.write(data);
        out.write(ByteBuffer.allocate(4).putInt((int) crc.getValue()).array());
    }

    private static byte[] gif() {
        byte[] gif = ByteBuffer.allocate(24).order(ByteOrder.LITTLE_ENDIAN)
            .put("GIF89a".getBytes(StandardCharsets.US_ASCII)).putShort((short) -1)
            .putShort((short) -1).put((byte) 0).put((byte) 0).put((byte) 0).put((byte) ',').putShort((short) 0)
            .putShort((short) 0).putShort((short) -1).putShort((short) -1).put((byte) 0).array();
        return gif;
    }

    /** Its header states the length of the data; newer Javas do not read the size without it. */
    private static byte[] bmp() {
        return ByteBuffer.allocate(54).order(ByteOrder.LITTLE_ENDIAN).put((byte) 'B').put((byte) 'M')
            .putInt(54 + 12_000 * 8_000 * 3).putInt(0)
            .putInt(54).putInt(40).putInt(12_000).putInt(8_000).putShort((short) 1).putShort((short) 24).putInt(0)
            .putInt(0).array();
    }

    private static byte[] jpeg() {
        ByteBuffer out = ByteBuffer.allocate(60);
        out.putShort((short) 0xffd8).putShort((short) 0xffe0).putShort((short) 16)
            .put("JFIF\0".getBytes(StandardCharsets.US_ASCII))
            .putShort((short) 0x0101).put((byte) 0).putShort((short) 1).putShort((short) 1).putShort((short) 0);
        out.putShort((short) 0xffc0).putShort((short) 11).put((byte) 8).putShort((short) 65_500)
            .putShort((short) 65_500).put((byte) 1).put((byte) 1).put((byte) 0x11).put((byte) 0);
        out.putShort((short) 0xffda).putShort((short) 8).put((byte) 1).put((byte) 1).put((byte) 0).put((byte) 0)
            .put((byte) 63).put((byte) 0);
        return out.array();
    }
}
