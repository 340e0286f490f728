// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.tiff;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.SEAR.files.FileLimits;

/**
 * Tags of the first image of a TIFF or BigTIFF. Ignores the following directories (overviews and masks), so circular
 * chains do no harm. Any thread after construction.
 */
public final class TiffFile {
    private static final int MAX_TAGS = 4096;
    private static final int[] SIZES = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
    private static final int BYTE = 1;
    private static final int ASCII = 2;
    private static final int SHORT = 3;
    private static final int LONG = 4;
    private static final int FLOAT = 11;
    private static final int DOUBLE = 12;
    private static final int LONG8 = 16;
    private static final int IFD8 = 18;

    public final MapBytes bytes;
    /** Name of the file in messages. */
    public final String name;
    final ByteOrder order;
    private final boolean big;
    private final Map<Integer, Tag> tags = new HashMap<>();

    /** @throws IOException that describes an error in the header or directory */
    public TiffFile(MapBytes bytes) throws IOException {
        this.bytes = bytes;
        this.name = bytes.getName();
        byte[] head = bytes.read("the head", 0, 8);
        this.order = head[0] == 'M' ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
        int version = ByteBuffer.wrap(head).order(order).getShort(2);
        this.big = version == 43;
        if (version != 42 && version != 43) {
            throw FileLimits.wrong(name, "the version of the TIFF", version, "42, or 43 for a BigTIFF");
        }
        readTags(big ? part("the head", 8, 8).getLong()
            : Integer.toUnsignedLong(ByteBuffer.wrap(head).order(order).getInt(4)));
    }

    private ByteBuffer part(String what, long position, int length) throws IOException {
        return ByteBuffer.wrap(bytes.read(what, position, length)).order(order);
    }

    private void readTags(long start) throws IOException {
        int counter = big ? 8 : 2;
        int size = big ? 20 : 12;
        ByteBuffer first = part("the directory", start, counter);
        long count = big ? first.getLong() : Short.toUnsignedInt(first.getShort());
        FileLimits.range(name, "the number of tags", count, 1, MAX_TAGS);
        ByteBuffer all = part("the directory", start + counter, (int) count * size);
        for (int i = 0; i < count; i++) {
            int at = i * size;
            int type = Short.toUnsignedInt(all.getShort(at + 2));
            long values = big ? all.getLong(at + 4) : Integer.toUnsignedLong(all.getInt(at + 4));
            int valueAt = at + (big ? 12 : 8);
            if (type < SIZES.length && SIZES[type] > 0) {
                boolean inside = values >= 0 && values <= (big ? 8 : 4) / SIZES[type];
                long position = inside ? start + counter + valueAt : big ? all.getLong(valueAt)
                    : Integer.toUnsignedLong(all.getInt(valueAt));
                tags.putIfAbsent(Short.toUnsignedInt(all.getShort(at)), new Tag(type, values, position));
            }
        }
    }

    public boolean has(int tag) {
        return tags.containsKey(tag);
    }

    /** Returns the values of a tag, or null. */
    private ByteBuffer values(int tag, String what, int most) throws IOException {
        Tag found = tags.get(tag);
        if (found == null) {
            return null;
        }
        FileLimits.range(name, "the number of values of " + what, found.count, 1, most);
        return part(what, found.position, (int) (found.count * SIZES[found.type]));
    }

    /**
     * Returns whole numbers.
     * @param what the tag's name in messages
     * @param most maximum number of values
     * @return null if the tag is missing
     */
    public long[] longs(int tag, String what, int most) throws IOException {
        ByteBuffer in = values(tag, what, most);
        if (in == null) {
            return null;
        }
        int type = tags.get(tag).type;
        long[] numbers = new long[(int) tags.get(tag).count];
        for (int i = 0; i < numbers.length; i++) {
            if (type == SHORT) {
                numbers[i] = Short.toUnsignedInt(in.getShort());
            } else if (type == LONG || type == 13) {
                numbers[i] = Integer.toUnsignedLong(in.getInt());
            } else if (type >= LONG8 && type <= IFD8) {
                numbers[i] = in.getLong();
            } else if (type == BYTE) {
                numbers[i] = in.get() & 0xff;
            } else {
                throw FileLimits.wrong(name, "the type of " + what, type, "a whole number (1, 3, 4, 13, 16, 17 or 18)");
            }
        }
        return numbers;
    }

    /** Returns one whole number between bounds, or the default without the tag. */
    public int number(int tag, String what, int without, int low, int high) throws IOException {
        long[] numbers = longs(tag, what, 1 << 16);
        long value = numbers == null ? without : numbers[0];
        FileLimits.range(name, what, value, low, high);
        return (int) value;
    }

    /** Returns floating-point numbers, or null without the tag. */
    public double[] doubles(int tag, String what, int most) throws IOException {
        ByteBuffer in = values(tag, what, most);
        if (in == null) {
            return null;
        }
        int type = tags.get(tag).type;
        if (type != DOUBLE && type != FLOAT) {
            throw FileLimits.wrong(name, "the type of " + what, type, "float or double (11 or 12)");
        }
        double[] numbers = new double[(int) tags.get(tag).count];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = type == DOUBLE ? in.getDouble() : in.getFloat();
        }
        return numbers;
    }

    /** Returns a text up to its terminator, or null if the tag is missing or not text. */
    public String text(int tag, String what, int most) throws IOException {
        ByteBuffer in = has(tag) && tags.get(tag).type == ASCII ? values(tag, what, most) : null;
        if (in == null) {
            return null;
        }
        String text = new String(in.array(), StandardCharsets.ISO_8859_1);
        int end = text.indexOf(0);
        return end < 0 ? text : text.substring(0, end);
    }

    /** Type, number and position of a tag's values. */
    private static final class Tag {
        final int type;
        final long count;
        final long position;

        Tag(int type, long count, long position) {
            this.type = type;
            this.count = count;
            this.position = position;
        }
    }
}
