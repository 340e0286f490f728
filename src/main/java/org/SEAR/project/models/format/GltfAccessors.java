// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.SEAR.files.FileLimits;

/** Reads the numbers of accessors that {@link GltfCheck} has checked, sparse ones too. */
final class GltfAccessors {
    private static final int BYTE = 5120;
    private static final int UNSIGNED_BYTE = 5121;
    private static final int SHORT = 5122;
    private static final int UNSIGNED_SHORT = 5123;
    private static final int UNSIGNED_INT = 5125;
    private static final int FLOAT = 5126;

    /** Content of the buffers. */
    interface Buffers {
        byte[] data(int buffer) throws IOException;
    }

    private final GltfJson json;
    private final Buffers buffers;

    GltfAccessors(GltfJson json, Buffers buffers) {
        this.json = json;
        this.buffers = buffers;
    }

    private JsonObject accessor(int number) throws IOException {
        return json.object(json.list("accessors"), "accessors", number);
    }

    /** Returns the number of elements. */
    int count(int accessor) throws IOException {
        return (int) json.whole(accessor(accessor), "", "count", 0, 0, Integer.MAX_VALUE);
    }

    /** Returns the number of numbers of an element. */
    int components(int accessor) throws IOException {
        return GltfCheck.COMPONENTS.get(json.text(accessor(accessor), "", "type", ""));
    }

    /**
     * Returns all numbers, normalized ones from -1 or 0 to 1.
     *
     * @param what place of the reference in the file, for errors
     * @param count legal number of elements
     * @param components legal numbers of numbers of an element, ascending
     */
    float[] floats(int accessor, String what, int count, int... components) throws IOException {
        require(accessor, what, count, components);
        double[] steps = {127, 255, 32767, 65535};
        JsonObject in = accessor(accessor);
        int type = type(in);
        double step = json.flag(in, "", "normalized") && type <= UNSIGNED_SHORT ? steps[type - BYTE] : 1;
        float[] values = new float[count * components(accessor)];
        read(in, (at, value) -> values[at] = (float) (step == 1 ? value : Math.max(-1, value / step)));
        return values;
    }

    /** Returns all elements of unsigned whole numbers, from 0 up to but not including a limit. */
    int[] whole(int accessor, String what, int count, int components, int limit) throws IOException {
        require(accessor, what, count, components);
        JsonObject in = accessor(accessor);
        int type = type(in);
        if (type != UNSIGNED_BYTE && type != UNSIGNED_SHORT && type != UNSIGNED_INT) {
            throw FileLimits.wrong(json.file, "the componentType of " + what, type, "one of 5121, 5123, 5125");
        }
        int[] values = new int[count * components];
        int[] first = {-1};
        read(in, (at, value) -> {
            values[at] = (int) value;
            if (value >= limit && first[0] < 0) {
                first[0] = at;
            }
        });
        if (first[0] >= 0) {
            throw FileLimits.wrong(json.file, what + "[" + first[0] + "], an index of the file,",
                Integer.toUnsignedString(values[first[0]]),
                "0 to " + (limit - 1));
        }
        return values;
    }

    private void require(int accessor, String what, int count, int... components) throws IOException {
        if (count(accessor) != count) {
            throw FileLimits.wrong(json.file, "the number of elements of " + what, count(accessor),
                String.valueOf(count));
        }
        int given = components(accessor);
        for (int legal : components) {
            if (legal == given) {
                return;
            }
        }
        throw FileLimits.wrong(json.file, "the number of numbers of an element of " + what, given,
            components[0] + " to " + components[components.length - 1]);
    }

    private int type(JsonObject in) throws IOException {
        return (int) json.whole(in, "", "componentType", 0, 0, Integer.MAX_VALUE);
    }

    /** Takes each number of an accessor. */
    private interface Sink {
        void put(int at, double value);
    }

    private void read(JsonObject accessor, Sink sink) throws IOException {
        int components = GltfCheck.COMPONENTS.get(json.text(accessor, "", "type", ""));
        int count = (int) json.whole(accessor, "", "count", 0, 0, Integer.MAX_VALUE);
        if (accessor.has("bufferView")) {
            read(accessor, type(accessor), components, count, sink);
        }
        if (accessor.has("sparse")) {
            JsonObject sparse = json.object(accessor, "", "sparse");
            JsonObject indices = json.object(sparse, "", "indices");
            int changed = (int) json.whole(sparse, "", "count", 0, 0, Integer.MAX_VALUE);
            int[] to = new int[changed];
            read(indices, type(indices), 1, changed, (at, value) -> to[at] = (int) Math.min(value, Integer.MAX_VALUE));
            for (int index : to) {
                FileLimits.range(json.file, "an index of a sparse accessor", index, 0, count - 1);
            }
            read(json.object(sparse, "", "values"), type(accessor), components, changed,
                (at, value) -> sink.put(to[at / components] * components + at % components, value));
        }
    }

    private void read(JsonObject in, int type, int components, int count, Sink sink) throws IOException {
        JsonObject view = json.object(json.list("bufferViews"), "bufferViews", json.reference(in, "", "bufferView",
            "bufferViews"));
        ByteBuffer data = ByteBuffer.wrap(buffers.data(json.reference(view, "", "buffer", "buffers")))
            .order(ByteOrder.LITTLE_ENDIAN);
        int size = GltfCheck.BYTES.get(type);
        int stride = Math.max(size * components, (int) json.whole(view, "", "byteStride", 0, 0, 252));
        int first = (int) (json.whole(view, "", "byteOffset", 0, 0, Integer.MAX_VALUE)
            + json.whole(in, "", "byteOffset", 0, 0, Integer.MAX_VALUE));
        for (int i = 0; i < count; i++) {
            for (int component = 0; component < components; component++) {
                sink.put(i * components + component, number(data, first + i * stride + component * size, type));
            }
        }
    }

    private static double number(ByteBuffer data, int at, int type) {
        switch (type) {
            case BYTE:
                return data.get(at);
            case UNSIGNED_BYTE:
                return Byte.toUnsignedInt(data.get(at));
            case SHORT:
                return data.getShort(at);
            case UNSIGNED_SHORT:
                return Short.toUnsignedInt(data.getShort(at));
            case UNSIGNED_INT:
                return Integer.toUnsignedLong(data.getInt(at));
            case FLOAT:
            default:
                return data.getFloat(at);
        }
    }
}
