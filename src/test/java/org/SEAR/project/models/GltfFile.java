// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;

/** A glTF file of parts: views, accessors, primitives, nodes; the rest is text. */
final class GltfFile {
    private final ByteArrayOutputStream data = new ByteArrayOutputStream();
    private final List<String> views = new ArrayList<>();
    private final List<String> accessors = new ArrayList<>();
    private final List<String> primitives = new ArrayList<>();
    private final List<String> nodes = new ArrayList<>();
    private String mesh = "";
    private String roots = "0";
    private String others = "";

    /** A cube from (0, 0, 0) to (1, 1, 1): accessors 0 and 1. */
    static GltfFile cube() {
        GltfFile file = new GltfFile();
        file.floats(3, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1);
        file.indices(5123, 0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3,
            0, 4, 3, 4, 7);
        return file;
    }

    private static String type(int components) {
        return components == 1 ? "SCALAR" : components == 16 ? "MAT4" : "VEC" + components;
    }

    private int view(byte[] bytes, String more) {
        while (data.size() % 4 != 0) {
            data.write(0);
        }
        views.add("{\"buffer\":0,\"byteOffset\":" + data.size() + ",\"byteLength\":" + bytes.length + more + "}");
        data.write(bytes, 0, bytes.length);
        return views.size() - 1;
    }

    /** Returns the number of a view with numbers of a component type. */
    int view(int type, double... values) {
        return view(bytes(type, values), "");
    }

    static byte[] bytes(int type, double... values) {
        ByteBuffer out = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (double value : values) {
            if (type <= 5121) {
                out.put((byte) value);
            } else if (type <= 5123) {
                out.putShort((short) (int) value);
            } else if (type == 5125) {
                out.putInt((int) (long) value);
            } else {
                out.putFloat((float) value);
            }
        }
        return java.util.Arrays.copyOf(out.array(), out.position());
    }

    int accessor(String text) {
        accessors.add("{" + text + "}");
        return accessors.size() - 1;
    }

    int floats(int components, double... values) {
        return numbers(5126, components, "", values);
    }

    int numbers(int type, int components, String more, double... values) {
        return accessor("\"bufferView\":" + view(type, values) + ",\"componentType\":" + type + ",\"count\":"
            + values.length / components
            + ",\"type\":\"" + type(components) + "\"" + more);
    }

    int indices(int type, double... values) {
        return numbers(type, 1, "", values);
    }

    /** Vertices of the given floats each, of which an accessor takes three at an offset, in floats. */
    int interleaved(int stride, int offset, double... values) {
        int view = view(bytes(5126, values), ",\"byteStride\":" + 4 * stride);
        return accessor("\"bufferView\":" + view + ",\"byteOffset\":" + 4 * offset
            + ",\"componentType\":5126,\"count\":" + values.length / stride
            + ",\"type\":\"VEC3\"");
    }

    GltfFile primitive(String text) {
        primitives.add("{" + text + "}");
        return this;
    }

    GltfFile mesh(String more) {
        mesh = more;
        return this;
    }

    GltfFile node(String text) {
        nodes.add("{" + text + "}");
        return this;
    }

    GltfFile roots(String text) {
        roots = text;
        return this;
    }

    GltfFile with(String text) {
        others = text;
        return this;
    }

    /** The cube's triangles, if there are no others, in a node. */
    String text() {
        if (primitives.isEmpty()) {
            primitive("\"attributes\":{\"POSITION\":0},\"indices\":1");
        }
        if (nodes.isEmpty()) {
            node("\"mesh\":0");
        }
        String scenes = roots.startsWith("[") ? roots : "[{\"nodes\":[" + roots + "]}]";
        return "{\"asset\":{\"version\":\"2.0\"},\"scenes\":" + scenes + ",\"nodes\":" + nodes
            + ",\"meshes\":[{\"primitives\":" + primitives + mesh
            + "}],\"accessors\":" + accessors + ",\"bufferViews\":" + views + ",\"buffers\":[{\"byteLength\":"
            + data.size()
            + ",\"uri\":\"data:application/octet-stream;base64,"
            + Base64.getEncoder().encodeToString(data.toByteArray()) + "\"}]" + others + "}";
    }

    byte[] bytes() {
        return text().getBytes(StandardCharsets.UTF_8);
    }
}
