// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.TreeMap;

/** Class of objects in a .j3o, and the layout of its fields (jMonkeyEngine, BinaryClassField). */
final class J3oClass {
    /** Marks of a missing object and of a default one, in place of a length. */
    private static final int NULL = -1;
    private static final int DEFAULT = -2;
    private static final int BITS = 80;
    private static final int OBJECT = 90;
    private static final int STRING = 70;
    private static final int INT = 10;
    /** First type of lists of objects: one dimension more than arrays. */
    private static final int LISTS = 100;
    private static final int MAP = 105;
    private static final int MAP_OF_TEXTS = 106;
    private static final int MAP_OF_NUMBERS = 107;
    private static final int FLOAT_BUFFERS = 110;
    private static final int BYTE_BUFFERS = 111;
    /** First type of buffers: floats, ints, bytes, shorts. */
    private static final int BUFFERS = 120;
    private static final int[] BUFFER_BYTES = {4, 4, 1, 2};
    /** Bytes of the simple types byte, int, float, double, long, short, boolean; 0 for a length of its own. */
    private static final int[] BYTES = {1, 0, 4, 8, 0, 2, 1};

    final String name;
    /** Type of each field. */
    final Map<Byte, Byte> types = new TreeMap<>();
    /** Name of each field. */
    final Map<Byte, String> names = new TreeMap<>();

    J3oClass(String name) {
        this.name = name;
    }

    /** Skips a value; returns false if it is longer than the rest, or of an unknown type. */
    static boolean skip(ByteBuffer in, int type) {
        switch (type) {
            case MAP:
                return skip(in, OBJECT, 2);
            case MAP_OF_TEXTS:
            case MAP_OF_NUMBERS:
                int entries = length(in);
                return entries == NULL || entries >= 0 && skip(in, type == MAP_OF_TEXTS ? STRING : INT, 1) && skip(in,
                    OBJECT, 1);
            case FLOAT_BUFFERS:
            case BYTE_BUFFERS:
                return skip(in, BUFFERS + (type == FLOAT_BUFFERS ? 0 : 2), 1);
            default:
                if (type >= LISTS && type < MAP) {
                    return skip(in, OBJECT, type - LISTS + 1);
                }
                return type >= BUFFERS ? skip(in, type, 0) : type % 10 <= 2 && skip(in, type / 10 * 10, type % 10);
        }
    }

    private static boolean skip(ByteBuffer in, int type, int dimensions) {
        if (dimensions > 0) {
            int count = length(in);
            boolean fits = count == NULL || count >= 0 && count <= in.remaining();
            for (int i = 0; i < count && fits; i++) {
                fits = skip(in, type, dimensions - 1);
            }
            return fits;
        }
        if (type >= BUFFERS) {
            return type - BUFFERS < BUFFER_BYTES.length && skipAll(in, length(in), BUFFER_BYTES[type - BUFFERS]);
        }
        if (type == OBJECT) {
            return length(in) > Integer.MIN_VALUE;
        }
        if (type == STRING || type == BITS) {
            return skipAll(in, length(in), 1);
        }
        if (type < 0 || type / INT >= BYTES.length) {
            return false;
        }
        int bytes = BYTES[type / INT];
        return bytes == 0 ? number(in, type == INT ? Integer.BYTES : Long.BYTES) > Long.MIN_VALUE : skipAll(in, 1,
            bytes);
    }

    private static boolean skipAll(ByteBuffer in, int count, int bytes) {
        if (count == NULL) {
            return true;
        }
        if (count < 0 || (long) count * bytes > in.remaining()) {
            return false;
        }
        in.position(in.position() + count * bytes);
        return true;
    }

    private static int length(ByteBuffer in) {
        return (int) Math.max(Integer.MIN_VALUE, number(in, Integer.BYTES));
    }

    /** Returns a number after the number of its bytes; {@code Long.MIN_VALUE} if it is longer than the rest. */
    private static long number(ByteBuffer in, int most) {
        int bytes = in.hasRemaining() ? in.get() : most + 1;
        if (bytes == NULL || bytes == DEFAULT) {
            return bytes;
        }
        if (bytes < 0 || bytes > most || bytes > in.remaining()) {
            return Long.MIN_VALUE;
        }
        long value = 0;
        for (int i = 0; i < bytes; i++) {
            value = value << Byte.SIZE | Byte.toUnsignedInt(in.get());
        }
        return most == Integer.BYTES ? (int) value : Math.max(value, Long.MIN_VALUE + 1);
    }
}
