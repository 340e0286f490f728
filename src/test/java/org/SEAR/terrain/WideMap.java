// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import org.SEAR.files.Assets;

/** Writes a GeoTIFF of any size: the mountains of Jacksboro, mirrored repeatedly, one sample per arc second. */
public final class WideMap {
    private static final int SHORT = 3;
    private static final int LONG = 4;
    private static final int DOUBLE = 12;
    private static final int STRIP = 64;
    private static final double STEP = 1.0 / 3600;

    private final int side;
    private final MapRaster real;

    /** @param side samples from north to south, and from west to east */
    public WideMap(int side) throws IOException {
        this.side = side;
        Assets assets = new Assets(Paths.get(System.getProperty("sear.root", "."), "resources/org/SEAR/assets"));
        try (Mosaic mosaic = Mosaic.open(assets, Collections.singletonList("terrain/jacksboro.tif"))) {
            real = mosaic.read(0, 0, mosaic.rows, mosaic.columns);
        }
    }

    /** Returns the elevation of a sample, metres; rows from the north, columns from the west. */
    public int height(int row, int column) {
        int r = row % (2 * real.rows);
        int c = column % (2 * real.columns);
        return (int) real.heights[(r < real.rows ? r : 2 * real.rows - 1 - r) * real.columns
            + (c < real.columns ? c : 2 * real.columns - 1 - c)];
    }

    /** Returns the latitude of a row of samples, degrees. */
    public static double latitude(double row) {
        return 38 - (row + 0.5) * STEP;
    }

    /** Returns the longitude of a column of samples, degrees. */
    public static double longitude(double column) {
        return -86 + (column + 0.5) * STEP;
    }

    /** Writes the file uncompressed. */
    public void write(Path path) throws IOException {
        int strips = (side - 1) / STRIP + 1;
        int head = 2 + 12 * 13 + 4;
        long data = 8L + head + 8L * strips + 24 + 48 + 32;
        ByteBuffer b = ByteBuffer.allocate((int) data).order(ByteOrder.LITTLE_ENDIAN);
        b.put((byte) 'I').put((byte) 'I').putShort((short) 42).putInt(8);
        int offsets = 8 + head;
        int counts = offsets + 4 * strips;
        int scale = counts + 4 * strips;
        b.putShort((short) 13);
        tag(b, 256, LONG, 1, side);
        tag(b, 257, LONG, 1, side);
        tag(b, 258, SHORT, 1, 16);
        tag(b, 259, SHORT, 1, 1);
        tag(b, 262, SHORT, 1, 1);
        tag(b, 273, LONG, strips, offsets);
        tag(b, 277, SHORT, 1, 1);
        tag(b, 278, LONG, 1, STRIP);
        tag(b, 279, LONG, strips, counts);
        tag(b, 339, SHORT, 1, 2);
        tag(b, 33550, DOUBLE, 3, scale);
        tag(b, 33922, DOUBLE, 6, scale + 24);
        tag(b, 34735, SHORT, 16, scale + 72);
        b.putInt(0);
        for (int i = 0; i < strips; i++) {
            b.putInt((int) (data + 2L * side * STRIP * i));
        }
        for (int i = 0; i < strips; i++) {
            b.putInt(2 * side * Math.min(STRIP, side - STRIP * i));
        }
        b.putDouble(STEP).putDouble(STEP).putDouble(0);
        b.putDouble(0).putDouble(0).putDouble(0).putDouble(-86).putDouble(38).putDouble(0);
        for (int key : new int[] {1, 1, 0, 3, 1024, 0, 1, 2, 1025, 0, 1, 1, 2048, 0, 1, 4326}) {
            b.putShort((short) key);
        }
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(path), 1 << 20)) {
            out.write(b.array());
            byte[] line = new byte[2 * side];
            for (int row = 0; row < side; row++) {
                for (int column = 0; column < side; column++) {
                    int height = height(row, column);
                    line[2 * column] = (byte) height;
                    line[2 * column + 1] = (byte) (height >> 8);
                }
                out.write(line);
            }
        }
    }

    private static void tag(ByteBuffer b, int tag, int type, int count, int value) {
        b.putShort((short) tag).putShort((short) type).putInt(count);
        if (type == SHORT && count == 1) {
            b.putShort((short) value).putShort((short) 0);
        } else {
            b.putInt(value);
        }
    }
}
