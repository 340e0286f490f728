// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Writes elevations as a plain GeoTIFF: 32-bit floating point, one uncompressed strip, pixel is point,
 * ModelTransformation (OGC GeoTIFF 1.1, TIFF 6.0). One use, one thread.
 */
public final class GeoTiffWriter {
    private static final int SHORT = 3;
    private static final int LONG = 4;
    private static final int DOUBLE = 12;
    private static final int ASCII = 2;
    private static final int MATRIX = 16;
    private static final int HEAD = 8;
    private static final int ENTRY = 12;
    private static final int FLOAT_SAMPLES = 3;
    private static final int FLOAT_BITS = 32;
    private static final String EPSG = "EPSG:";

    private final List<byte[]> entries = new ArrayList<>();
    private final ByteArrayOutputStream values = new ByteArrayOutputStream();
    private int valuesAt;

    private GeoTiffWriter() {
    }

    /** Returns whether a georeference can be written: its coordinate system needs an EPSG number. */
    public static boolean canWrite(Georeference place) {
        return place != null && place.system != null && place.system.matches(EPSG + "[0-9]{1,5}");
    }

    /**
     * Returns the bytes of a file.
     * @param place georeference that {@link #canWrite}; the first post is in row 0 and column 0
     * @param degrees whether the coordinate system is geographic
     * @param heights metres, row by row, NaN for no data
     */
    public static byte[] bytes(Georeference place, boolean degrees, int rows, int columns, float[] heights) {
        return new GeoTiffWriter().write(place, degrees, rows, columns, heights);
    }

    private byte[] write(Georeference place, boolean degrees, int rows, int columns, float[] heights) {
        int size = Float.BYTES * rows * columns;
        int directory = HEAD + size;
        int count = 14;
        valuesAt = directory + Short.BYTES + count * ENTRY + Integer.BYTES;
        whole(256, columns);
        whole(257, rows);
        shorts(258, FLOAT_BITS);
        shorts(259, 1);
        shorts(262, 1);
        whole(273, HEAD);
        shorts(277, 1);
        whole(278, rows);
        whole(279, size);
        shorts(284, 1);
        shorts(339, FLOAT_SAMPLES);
        double[] matrix = new double[MATRIX];
        matrix[0] = place.xColumn;
        matrix[1] = place.xRow;
        matrix[3] = place.x0;
        matrix[4] = place.yColumn;
        matrix[5] = place.yRow;
        matrix[7] = place.y0;
        matrix[MATRIX - 1] = 1;
        doubles(34264, matrix);
        int system = Integer.parseInt(place.system.substring(EPSG.length()));
        shorts(34735, 1, 1, 0, 3, 1024, 0, 1, degrees ? 2 : 1, 1025, 0, 1, 2, degrees ? 2048 : 3072, 0, 1, system);
        text(42113, "nan");
        ByteBuffer out = buffer(valuesAt + values.size());
        out.put((byte) 'I').put((byte) 'I').putShort((short) 42).putInt(directory);
        for (float height : heights) {
            out.putFloat(height);
        }
        out.putShort((short) entries.size());
        entries.forEach(out::put);
        out.putInt(0).put(values.toByteArray());
        return out.array();
    }

    private static ByteBuffer buffer(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }

    private void whole(int tag, int value) {
        entry(tag, LONG, 1, buffer(Integer.BYTES).putInt(value).array());
    }

    private void shorts(int tag, int... numbers) {
        ByteBuffer bytes = buffer(Short.BYTES * numbers.length);
        for (int number : numbers) {
            bytes.putShort((short) number);
        }
        entry(tag, SHORT, numbers.length, bytes.array());
    }

    private void doubles(int tag, double... numbers) {
        ByteBuffer bytes = buffer(Double.BYTES * numbers.length);
        for (double number : numbers) {
            bytes.putDouble(number);
        }
        entry(tag, DOUBLE, numbers.length, bytes.array());
    }

    private void text(int tag, String text) {
        byte[] bytes = (text + '\0').getBytes(StandardCharsets.US_ASCII);
        entry(tag, ASCII, bytes.length, bytes);
    }

    /** Adds an entry of the directory. Values of more than four bytes follow the directory at an even offset. */
    private void entry(int tag, int type, int number, byte[] value) {
        ByteBuffer entry = buffer(ENTRY).putShort((short) tag).putShort((short) type).putInt(number);
        if (value.length <= Integer.BYTES) {
            entry.put(value);
        } else {
            entry.putInt(valuesAt + values.size());
            values.write(value, 0, value.length);
            if (value.length % 2 == 1) {
                values.write(0);
            }
        }
        entries.add(entry.array());
    }
}
