// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.Closeable;
import java.io.IOException;
import org.SEAR.files.FileLimits;
import org.SEAR.terrain.tiff.MapBytes;
import org.SEAR.terrain.tiff.TiffFile;
import org.SEAR.terrain.tiff.TiffImage;

/**
 * GeoTIFF of colours, such as an aerial picture: grey or RGB, with or without alpha, 8 bits each. One thread at a time.
 */
public final class TiffPicture implements Closeable {
    private static final int PALETTE = 3;
    private static final int CMYK = 5;

    /** Georeference of the pixels' centres. */
    public final Georeference place;
    /** Number of rows; in most pictures the first is the northernmost. */
    public final int rows;
    /** Number of columns; in most pictures the first is the westernmost. */
    public final int columns;
    private final TiffImage image;

    private TiffPicture(TiffImage image, Georeference place) {
        this.image = image;
        this.place = place;
        this.rows = image.rows;
        this.columns = image.columns;
    }

    /**
     * Opens a picture.
     * @throws IOException that names the file, the invalid value and the legal ones
     */
    public static TiffPicture open(MapBytes bytes) throws IOException {
        TiffFile file = new TiffFile(bytes);
        TiffImage image = new TiffImage(file);
        if (image.sampleBytes != 1 || image.sampleFormat != 1 || image.samples > 4) {
            throw FileLimits.wrong(file.name, "the pixels", image.samples + " values of "
                + 8 * image.sampleBytes + " bits",
                "1 to 4 values of 8 bits without sign: grey, or red, green and blue, and transparency");
        }
        int photometric = file.number(262, "PhotometricInterpretation", 1, 0, 65535);
        if (photometric == PALETTE || photometric >= CMYK) {
            throw FileLimits.wrong(file.name, "PhotometricInterpretation", photometric,
                "0, 1 (grey) or 2 (red, green, blue), for example by gdal_translate -expand rgb");
        }
        Georeference place = new GeoKeys(file).place();
        if (place == null || place.system == null) {
            throw FileLimits.wrong(file.name, "the place on Earth", "not known",
                "a GeoTIFF with a coordinate system; any other picture fills the area");
        }
        return new TiffPicture(image, place);
    }

    /**
     * Reads a downscaled part.
     * @param row first row, likewise column
     * @param height number of rows, all inside the picture; likewise width
     * @param factor number of pixels per side that are averaged to one
     * @return colours 0xAARRGGBB, row by row; the last row and column may average fewer pixels
     */
    public int[] read(int row, int column, int height, int width, int factor) throws IOException {
        image.requireFew(row, column, height, width);
        int across = (width + factor - 1) / factor;
        int[] colours = new int[across * ((height + factor - 1) / factor)];
        long[] sums = new long[4 * across];
        int from = row;
        while (from < row + height) {
            int down = from / image.blockRows;
            long end = Math.min((long) row + height, (down + 1L) * image.blockRows);
            int to = (int) Math.min(end, (long) from + image.rowsAtOnce());
            byte[][] blocks = blocks(down, from - down * image.blockRows, to - from, column, width);
            for (int r = from; r < to; r++) {
                add(blocks, r - from, column, width, factor, sums);
                int done = r - row + 1;
                if (done % factor == 0 || done == height) {
                    flush(sums, width, factor, (done - 1) % factor + 1, colours, (done - 1) / factor * across);
                }
            }
            from = to;
        }
        return colours;
    }

    private byte[][] blocks(int down, int from, int count, int column, int width) throws IOException {
        int first = column / image.blockColumns;
        int many = (column + width - 1) / image.blockColumns - first + 1;
        FileLimits.range(image.file.name, "the size of a row of tiles",
            many * image.rowBytes() * count * (image.together ? 1 : image.samples), 0, TiffImage.MAX_BLOCK);
        int planes = image.together ? 1 : image.samples;
        byte[][] blocks = new byte[many * planes][];
        for (int i = 0; i < blocks.length; i++) {
            blocks[i] = image.unpack(first + i / planes, down, i % planes, from, count);
        }
        return blocks;
    }

    /** Adds a row's colours to the sums of the downscaled pixels. */
    private void add(byte[][] blocks, int row, int column, int width, int factor, long[] sums) {
        int planes = image.together ? 1 : image.samples;
        int apart = image.samplesTogether();
        int first = column / image.blockColumns;
        for (int c = 0; c < width; c++) {
            int block = ((column + c) / image.blockColumns - first) * planes;
            int at = (row * image.blockColumns + (column + c) % image.blockColumns) * apart;
            int to = c / factor * 4;
            for (int colour = 0; colour < 3; colour++) {
                sums[to + colour] += value(blocks, block, at, image.samples < 3 ? 0 : colour);
            }
            boolean transparency = image.samples == 2 || image.samples == 4;
            sums[to + 3] += blocks[block] == null ? 0 : transparency
                ? value(blocks, block, at, image.samples - 1) : 255;
        }
    }

    private int value(byte[][] blocks, int block, int at, int sample) {
        byte[] bytes = blocks[image.together ? block : block + sample];
        return bytes == null ? 0 : bytes[image.together ? at + sample : at] & 0xff;
    }

    private static void flush(long[] sums, int width, int factor, int rows, int[] colours, int at) {
        for (int i = 0; i < sums.length / 4; i++) {
            long count = (long) rows * Math.min(factor, width - i * factor);
            int argb = 0;
            for (int colour = 0; colour < 4; colour++) {
                int mean = (int) ((sums[4 * i + colour] + count / 2) / count);
                argb |= mean << (colour == 3 ? 24 : 16 - 8 * colour);
                sums[4 * i + colour] = 0;
            }
            colours[at + i] = argb;
        }
    }

    @Override
    public void close() throws IOException {
        image.file.bytes.close();
    }
}
