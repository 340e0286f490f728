// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;

/** Writes TIFFs tag by tag, valid and invalid ones. */
public final class TiffMaker {
    private static final int SHORT = 3;
    private static final int LONG = 4;
    private static final int DOUBLE = 12;

    private final Map<Integer, Object> tags = new TreeMap<>();
    private final byte[] pixels;
    private ByteOrder order = ByteOrder.LITTLE_ENDIAN;

    /** Makes an image of one uncompressed strip. */
    public TiffMaker(int columns, int rows, int bits, byte... pixels) {
        this.pixels = pixels;
        with(256, columns).with(257, rows).with(258, bits).with(259, 1).with(262, 1).with(273, 8).with(277, 1)
            .with(278, rows).with(279, pixels.length);
    }

    /** Makes elevations of 16 bits in degrees of WGS 84 from a north-west corner. */
    public static TiffMaker heights(int columns, int rows, double west, double north, double step, int... heights) {
        ByteBuffer bytes = ByteBuffer.allocate(2 * heights.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int height : heights) {
            bytes.putShort((short) height);
        }
        return new TiffMaker(columns, rows, 16, bytes.array()).with(339, 2).placed(west, north, step);
    }

    /** Sets corner and step in degrees of WGS 84. */
    public TiffMaker placed(double west, double north, double step) {
        return with(33550, new double[] {step, step, 0}).with(33922, new double[] {0, 0, 0, west, north, 0})
            .with(34735, new int[] {1, 1, 0, 2, 1024, 0, 1, 2, 2048, 0, 1, 4326});
    }

    /** Sets a tag: a number, int[] of shorts, long[] of 32-bit numbers, double[], a text, or null to remove it. */
    public TiffMaker with(int tag, Object value) {
        tags.put(tag, value);
        if (value == null) {
            tags.remove(tag);
        }
        return this;
    }

    /** Sets big-endian order for numbers; pixels stay unchanged. */
    public TiffMaker bigEndian() {
        order = ByteOrder.BIG_ENDIAN;
        return this;
    }

    /** Returns the file; its pixels follow the header. */
    public byte[] bytes() {
        int room = tags.values().stream().mapToInt(tag -> value(tag).length).sum();
        ByteBuffer out = ByteBuffer.allocate((1 << 16) + pixels.length + room).order(order);
        int directory = 8 + pixels.length;
        out.put((order == ByteOrder.BIG_ENDIAN ? "MM" : "II").getBytes(StandardCharsets.US_ASCII)).putShort((short) 42)
            .putInt(directory);
        out.put(pixels).putShort((short) tags.size());
        int values = directory + 2 + 12 * tags.size() + 4;
        for (Map.Entry<Integer, Object> tag : tags.entrySet()) {
            out.putShort((short) (int) tag.getKey());
            byte[] value = value(tag.getValue());
            int type = type(tag.getValue());
            int size = type == DOUBLE ? 8 : type == SHORT ? 2 : type == LONG ? 4 : 1;
            out.putShort((short) type).putInt(value.length / size);
            if (value.length > 4) {
                out.putInt(values);
                int back = out.position();
                out.position(values);
                out.put(value);
                values = out.position();
                out.position(back);
            } else {
                out.put(Arrays.copyOf(value, 4));
            }
        }
        out.putInt(directory);    // the next image is this one: a cycle
        byte[] all = new byte[Math.max(values, out.position())];
        System.arraycopy(out.array(), 0, all, 0, all.length);
        return all;
    }

    private static int type(Object value) {
        return value instanceof String ? 2 : value instanceof double[] ? DOUBLE : value instanceof int[] ? SHORT : LONG;
    }

    private byte[] value(Object value) {
        if (value instanceof String) {
            return (value + "\0").getBytes(StandardCharsets.US_ASCII);
        }
        if (value instanceof double[]) {
            ByteBuffer out = ByteBuffer.allocate(8 * ((double[]) value).length).order(order);
            for (double number : (double[]) value) {
                out.putDouble(number);
            }
            return out.array();
        }
        if (value instanceof long[]) {
            ByteBuffer out = ByteBuffer.allocate(4 * ((long[]) value).length).order(order);
            for (long number : (long[]) value) {
                out.putInt((int) number);
            }
            return out.array();
        }
        if (value instanceof int[]) {
            ByteBuffer out = ByteBuffer.allocate(2 * ((int[]) value).length).order(order);
            for (int number : (int[]) value) {
                out.putShort((short) number);
            }
            return out.array();
        }
        return ByteBuffer.allocate(4).order(order).putInt(((Number) value).intValue()).array();
    }
}
