// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.lang.ref.Cleaner;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.SEAR.files.FileLimits;

/**
 * Elevations of a map that exceed the memory, in a temporary file of four bytes per post. The file is deleted with this
 * object. Read-only after gaps are filled; any thread.
 */
final class RasterFile {
    private static final Cleaner CLEANER = Cleaner.create();
    /** Posts per side of a block whose mean gives a gap's start value. */
    private static final int BLOCK = 16;
    /** Rows before and after a strip that its gap filling takes into account. */
    private static final int AROUND = 64;

    final int row;
    final int column;
    final int rows;
    final int columns;
    private final String name;
    private final RandomAccessFile file;
    /** For each block, the sum of the elevations and the number of posts with data. */
    private final double[] sums;
    private final int[] counts;
    private final int blocksAcross;
    private double lowest = Double.POSITIVE_INFINITY;
    private double highest = Double.NEGATIVE_INFINITY;

    private RasterFile(String name, RandomAccessFile file, int[] part) {
        this.name = name;
        this.file = file;
        row = part[0];
        column = part[1];
        rows = part[2];
        columns = part[3];
        blocksAcross = (columns - 1) / BLOCK + 1;
        sums = new double[((rows - 1) / BLOCK + 1) * blocksAcross];
        counts = new int[sums.length];
    }

    /**
     * Copies a part of maps to a file.
     * @param part first row, first column, rows and columns
     * @param atOnce maximum number of posts in memory
     * @param warnings receives the share of posts without data
     * @throws IOException that names the map and the error
     */
    static RasterFile of(Mosaic mosaic, int[] part, int atOnce, List<String> warnings) throws IOException {
        String name = mosaic.first().name;
        RasterFile raster = new RasterFile(name, open(name, (long) Float.BYTES * part[2] * part[3]), part);
        CLEANER.register(raster, closing(raster.file));
        int many = Integer.highestOneBit(Math.max(2, atOnce / raster.columns));
        for (int first = 0; first < raster.rows; first += many) {
            int height = Math.min(many, raster.rows - first);
            float[] heights = mosaic.read(raster.row + first, raster.column, height, raster.columns).heights;
            raster.survey(first, heights);
            raster.write(first, heights, 0, height);
        }
        raster.fillGaps(many, warnings);
        return raster;
    }

    /** Opens a file and unlinks it if possible; otherwise deletes it at exit. */
    private static RandomAccessFile open(String name, long size) throws IOException {
        Path path = Files.createTempFile("sear-terrain-", ".heights");
        long room = Files.getFileStore(path).getUsableSpace();
        if (room < size) {
            Files.delete(path);
            throw FileLimits.wrong(name, "the free space for its elevations in the temporary folder "
                + path.getParent(), room + " bytes",
                size + " bytes or more: free space, choose another folder (-Djava.io.tmpdir=...), or use a "
                    + "smaller area");
        }
        RandomAccessFile file = new RandomAccessFile(path.toFile(), "rw");
        try {
            Files.delete(path);
        } catch (IOException e) {
            path.toFile().deleteOnExit();
        }
        return file;
    }

    private static Runnable closing(RandomAccessFile file) {
        return () -> {
            try {
                file.close();
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        };
    }

    private void survey(int first, float[] heights) {
        for (int at = 0; at < heights.length; at++) {
            float height = heights[at];
            if (!Float.isNaN(height)) {
                int block = (first + at / columns) / BLOCK * blocksAcross + at % columns / BLOCK;
                sums[block] += height;
                counts[block]++;
                lowest = Math.min(lowest, height);
                highest = Math.max(highest, height);
            }
        }
    }

    private synchronized void write(int first, float[] heights, int from, int height) throws IOException {
        byte[] line = new byte[Float.BYTES * columns];
        file.seek((long) Float.BYTES * first * columns);
        for (int r = from; r < from + height; r++) {
            ByteBuffer.wrap(line).asFloatBuffer().put(heights, r * columns, columns);
            file.write(line);
        }
    }

    private void fillGaps(int many, List<String> warnings) throws IOException {
        long full = 0;
        float[] means = new float[sums.length];
        for (int block = 0; block < means.length; block++) {
            full += counts[block];
            means[block] = counts[block] == 0 ? Float.NaN : (float) (sums[block] / counts[block]);
        }
        long posts = (long) rows * columns;
        FieldSampler.requireData(name, posts - full, posts, warnings);
        if (full == posts) {
            return;
        }
        int blocksDown = means.length / blocksAcross;
        GapFill.fill(means, blocksDown, blocksAcross);
        MapRaster coarse = new MapRaster(0, 0, blocksDown, blocksAcross, means);
        for (int first = 0; first < rows; first += many) {
            int height = Math.min(many, rows - first);
            if (hasGaps(first, height)) {
                fill(coarse, first, height);
            }
        }
    }

    private boolean hasGaps(int first, int height) {
        for (int down = first / BLOCK; down <= (first + height - 1) / BLOCK; down++) {
            int posts = Math.min(BLOCK, rows - down * BLOCK);
            for (int across = 0; across < blocksAcross; across++) {
                if (counts[down * blocksAcross + across] < posts * Math.min(BLOCK, columns - across * BLOCK)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Fills the gaps of a strip of rows, taking rows around it into account. */
    private void fill(MapRaster coarse, int first, int height) throws IOException {
        int from = Math.max(0, first - AROUND);
        int end = Math.min(rows, first + height + AROUND);
        float[] heights = read(from, 0, end - from, columns);
        GapFill.fill(heights, end - from, columns,
            at -> coarse.height((at % columns + 0.5) / BLOCK - 0.5, (from + at / columns + 0.5) / BLOCK - 0.5));
        write(first, heights, first - from, height);
    }

    /**
     * Reads posts.
     * @param top first row, counted from this part's first, likewise left
     */
    private synchronized float[] read(int top, int left, int height, int width) throws IOException {
        float[] heights = new float[height * width];
        byte[] line = new byte[Float.BYTES * width];
        for (int r = 0; r < height; r++) {
            file.seek(Float.BYTES * ((long) (top + r) * columns + left));
            file.readFully(line);
            ByteBuffer.wrap(line).asFloatBuffer().get(heights, r * width, width);
        }
        return heights;
    }

    /**
     * Reads the posts that surround some positions.
     * @param box bounds of the positions on the map: minimum column, minimum row, maximum column, maximum row
     */
    MapRaster around(double[] box) {
        int left = Math.min((int) Math.max(0, box[0] - column), columns - 2);
        int top = Math.min((int) Math.max(0, box[1] - row), rows - 2);
        int right = Math.min((int) Math.max(0, box[2] - column), columns - 2) + 1;
        int bottom = Math.min((int) Math.max(0, box[3] - row), rows - 2) + 1;
        try {
            return new MapRaster(row + top, column + left, bottom - top + 1, right - left + 1,
                read(top, left, bottom - top + 1, right - left + 1));
        } catch (IOException e) {
            throw new UncheckedIOException(
                new IOException(name + ": SEAR can't read its elevations in the temporary folder: "
                    + e.getMessage(), e));
        }
    }

    /** Returns the elevation at a position of the map, as {@link MapRaster#height} does. */
    double height(double atColumn, double atRow) {
        return around(new double[] {atColumn, atRow, atColumn, atRow}).height(this, atColumn, atRow);
    }

    /** Returns the minimum and maximum of the map, metres. */
    double[] range() {
        return new double[] {lowest, highest};
    }
}
