// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.tiff;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.SEAR.files.FileLimits;

/** Layout of the first image of a TIFF in strips or tiles, and their unpacked bytes. One thread at a time. */
public final class TiffImage {
    /** Maximum number of rows, and of columns. */
    public static final int MAX_SIDE = 1_000_000;
    /** Bytes per read of an uncompressed strip or tile. */
    private static final int PIECE = 8 << 20;
    private static final int MAX_BLOCKS = 4_000_000;
    /** Maximum number of strips and tiles read for one area, to limit the time. */
    private static final int MAX_READ = 100_000;
    /** Maximum size of one strip or tile, packed or unpacked, bytes. */
    public static final int MAX_BLOCK = 128 << 20;
    /** Maximum total of unpacked bytes per file, to limit the time for strips much wider than the area. */
    private static final long MAX_UNPACKED = 2L << 30;

    public final TiffFile file;
    /** Width, pixels. */
    public final int columns;
    /** Height, pixels. */
    public final int rows;
    /** Values per pixel. */
    public final int samples;
    /** Bytes per value. */
    public final int sampleBytes;
    /** 1 unsigned, 2 signed, 3 floating point. */
    public final int sampleFormat;
    /** True if strips or tiles contain all values of a pixel (chunky), false if one (planar). */
    public final boolean together;
    /** Whether unpacked values are big-endian. */
    public final boolean bigEndian;
    /** Columns of a strip or tile. */
    public final int blockColumns;
    /** Rows of a strip or tile. */
    public final int blockRows;
    private final boolean tiled;
    private final int blocksAcross;
    private final int blocksDown;
    private final int compression;
    private final int predictor;
    private final long[] offsets;
    private final long[] counts;
    private long unpacked;

    /** @throws IOException that describes an error in the tags */
    public TiffImage(TiffFile file) throws IOException {
        this.file = file;
        columns = file.number(256, "ImageWidth", 0, 1, MAX_SIDE);
        rows = file.number(257, "ImageLength", 0, 1, MAX_SIDE);
        samples = file.number(277, "SamplesPerPixel", 1, 1, 64);
        sampleBytes = sampleBytes();
        sampleFormat = sameFor("SampleFormat", 339, 1);
        together = file.number(284, "PlanarConfiguration", 1, 1, 2) == 1;
        compression = file.number(259, "Compression", 1, 0, 65535);
        TiffDecoder.require(file.name, compression);
        predictor = compression == TiffDecoder.NONE ? 1 : file.number(317, "Predictor", 1, 1, 3);
        file.number(266, "FillOrder", 1, 1, 1);
        if (sampleFormat < 1 || sampleFormat > 3 || sampleFormat == 3 && sampleBytes < 4) {
            throw FileLimits.wrong(file.name, "SampleFormat", sampleFormat + " with " + 8 * sampleBytes + " bits",
                "1 (unsigned), 2 (signed), or with 32 or 64 bits 3 (floating point)");
        }
        if (predictor == 3 && sampleFormat != 3) {
            throw FileLimits.wrong(file.name, "Predictor", 3, "1 or 2 for whole numbers");
        }
        bigEndian = predictor == 3 || file.order == ByteOrder.BIG_ENDIAN;
        tiled = file.has(322);
        blockColumns = tiled ? file.number(322, "TileWidth", 0, 1, MAX_SIDE) : columns;
        blockRows = tiled ? file.number(323, "TileLength", 0, 1, MAX_SIDE) : rowsPerStrip();
        blocksAcross = (columns + blockColumns - 1) / blockColumns;
        blocksDown = (rows + blockRows - 1) / blockRows;
        long blocks = (long) blocksAcross * blocksDown * (together ? 1 : samples);
        FileLimits.range(file.name, "the number of strips or tiles", blocks, 1, MAX_BLOCKS);
        offsets = table(tiled ? 324 : 273, tiled ? "TileOffsets" : "StripOffsets", (int) blocks);
        counts = table(tiled ? 325 : 279, tiled ? "TileByteCounts" : "StripByteCounts", (int) blocks);
        FileLimits.range(file.name, "the size of a row of a strip or tile", rowBytes(), 1, MAX_BLOCK);
    }

    private int rowsPerStrip() throws IOException {
        long[] given = file.longs(278, "RowsPerStrip", 1);
        if (given == null || given[0] >= rows) {
            return rows;
        }
        FileLimits.range(file.name, "RowsPerStrip", given[0], 1, Integer.MAX_VALUE);
        return (int) given[0];
    }

    private int sampleBytes() throws IOException {
        int bits = sameFor("BitsPerSample", 258, 1);
        if (bits != 8 && bits != 16 && bits != 32 && bits != 64) {
            throw FileLimits.wrong(file.name, "BitsPerSample", bits, "8, 16, 32 or 64");
        }
        return bits / 8;
    }

    private int sameFor(String what, int tag, int without) throws IOException {
        long[] values = file.longs(tag, what, 64);
        if (values == null) {
            return without;
        }
        for (long value : values) {
            if (value != values[0]) {
                throw FileLimits.wrong(file.name, what, Arrays.toString(values), "the same for all values of a pixel");
            }
        }
        return (int) Math.min(values[0], 65535);
    }

    private long[] table(int tag, String what, int blocks) throws IOException {
        long[] values = file.longs(tag, what, MAX_BLOCKS);
        if (values == null || values.length < blocks) {
            throw FileLimits.wrong(file.name, "the number of values of " + what, values == null ? 0 : values.length,
                String.valueOf(blocks));
        }
        return values;
    }

    /**
     * Throws if an area needs too many strips or tiles.
     * @param row first row, likewise column
     * @param height number of rows, likewise width
     * @throws IOException that contains their number
     */
    public void requireFew(int row, int column, int height, int width) throws IOException {
        long down = (row + height - 1) / blockRows - row / blockRows + 1L;
        long across = (column + width - 1) / blockColumns - column / blockColumns + 1L;
        long many = down * across * (together ? 1 : samples);
        if (many > MAX_READ) {
            throw FileLimits.wrong(file.name, "the number of strips or tiles in the area", many, "1 to " + MAX_READ
                + ": cut the map, or give it tiles of 256 x 256, for example by gdal_translate -co TILED=YES");
        }
    }

    /** Returns the number of strips and tiles beyond the end of the file. */
    public int countMissing() {
        int missing = 0;
        long size = file.bytes.size();
        for (int i = 0; i < offsets.length && i < counts.length; i++) {
            missing += offsets[i] > size || counts[i] > size - offsets[i] ? 1 : 0;
        }
        return missing;
    }

    /** Returns the number of strips and tiles. */
    public int count() {
        return blocksAcross * blocksDown * (together ? 1 : samples);
    }

    /** Returns the number of adjacent values per pixel in a strip or tile. */
    public int samplesTogether() {
        return together ? samples : 1;
    }

    /** Returns the size of a row of a strip or tile, bytes. */
    public long rowBytes() {
        return (long) blockColumns * samplesTogether() * sampleBytes;
    }

    /** Returns the number of rows to read together: all rows of a compressed block, which unpacks sequentially. */
    public int rowsAtOnce() {
        return compression == TiffDecoder.NONE ? (int) Math.max(1, PIECE / rowBytes()) : blockRows;
    }

    /**
     * Unpacks rows of a strip or tile.
     * @param across position of the strip or tile, counted from 0; likewise down
     * @param plane index of the value in a planar image
     * @param from first row within the strip or tile
     * @param count number of rows
     * @return null if the file omits the strip or tile
     * @throws IOException that describes the error
     */
    public byte[] unpack(int across, int down, int plane, int from, int count) throws IOException {
        int block = (plane * blocksDown + down) * blocksAcross + across;
        String what = (tiled ? "tile " : "strip ") + block;
        if (offsets[block] == 0 && counts[block] == 0) {
            return null;
        }
        int rowBytes = (int) rowBytes();
        FileLimits.range(file.name, "the size of " + what,
            (long) rowBytes * (compression == TiffDecoder.NONE ? count : from + count), 1, MAX_BLOCK);
        if (compression == TiffDecoder.NONE) {
            file.bytes.requirePart(what, offsets[block], (long) rowBytes * (from + count));
            return file.bytes.read(what, offsets[block] + (long) from * rowBytes, count * rowBytes);
        }
        FileLimits.range(file.name, "the number of bytes of " + what, counts[block], 1, MAX_BLOCK);
        byte[] packed = file.bytes.read(what, offsets[block], (int) counts[block]);
        byte[] all = new byte[(from + count) * rowBytes];
        unpacked += all.length;
        if (unpacked > MAX_UNPACKED) {
            throw FileLimits.wrong(file.name, "the data to unpack for the area", "more than " + MAX_UNPACKED + " bytes",
                "less: cut the map, for example by gdal_translate -projwin");
        }
        TiffDecoder.unpack(file.name, what, compression, packed, all);
        for (int row = from; row < from + count; row++) {
            TiffPredictor.undo(predictor, all, row * rowBytes, blockColumns, samplesTogether(), sampleBytes,
                file.order);
        }
        return from == 0 ? all : Arrays.copyOfRange(all, from * rowBytes, all.length);
    }
}
