// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.util.Arrays;
import java.util.Iterator;
import javax.imageio.IIOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.SEAR.files.FileLimits;
import org.SEAR.files.UnreadablePicture;

/** Picture of 8 or 16 bits whose greys are elevations: black the lowest, white the highest. Has no georeference. */
final class GreyPicture extends ElevationMap {
    private final Raster raster;

    private GreyPicture(String name, Raster raster, int bits) {
        super(name, raster.getHeight(), raster.getWidth(), null, Math.pow(2, bits) - 1);
        this.raster = raster;
    }

    /**
     * Decodes a picture.
     * @param bytes checked by {@link org.SEAR.files.Assets#readPicture}
     */
    static GreyPicture open(String name, byte[] bytes) throws IOException {
        BufferedImage image = unpacked(name, bytes);
        if (image.getColorModel() instanceof IndexColorModel) {
            throw FileLimits.wrong(name, "the picture", "one with a palette", "greys of 8 or 16 bits");
        }
        int bits = image.getSampleModel().getSampleSize(0);
        if (bits != 8 && bits != 16) {
            throw FileLimits.wrong(name, "the picture's depth", bits + " bits", "8 or 16 bits of grey");
        }
        return new GreyPicture(name, image.getRaster(), bits);
    }

    private static BufferedImage unpacked(String name, byte[] bytes) throws IOException {
        try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            if (!readers.hasNext()) {
                throw new UnreadablePicture(name + ": the picture is in no known format, legal: PNG, "
                    + "JPEG, GIF or BMP", null);
            }
            ImageReader reader = readers.next();
            try {
                reader.setInput(in, true, true);
                requireSize(name, reader.getHeight(0), reader.getWidth(0));
                return reader.read(0);
            } finally {
                reader.dispose();
            }
        } catch (RuntimeException | IIOException | EOFException e) {
            throw new UnreadablePicture(name + ": the picture is broken (" + e.getMessage()
                + "), legal: a whole picture", e);
        }
    }

    private static void requireSize(String name, int rows, int columns) throws IOException {
        FileLimits.range(name, "the number of pixels", (long) rows * columns, 4, MapLimits.MAX_POSTS);
        if (rows < 2 || columns < 2) {
            throw FileLimits.wrong(name, "the size", rows + " x " + columns, "at least 2 x 2 pixels");
        }
    }

    @Override
    public float[] read(int row, int column, int height, int width) throws IOException {
        float[] greys = new float[height * width];
        int colours = Math.min(raster.getNumBands(), 3);
        int[] line = new int[width];
        int[] other = new int[width];
        for (int r = 0; r < height; r++) {
            raster.getSamples(column, row + r, width, 1, 0, line);
            for (int band = 1; band < colours && colours == 3; band++) {
                raster.getSamples(column, row + r, width, 1, band, other);
                if (!Arrays.equals(line, other)) {
                    throw FileLimits.wrong(name, "the picture", "coloured (row " + (row + r) + ")",
                        "greys of 8 or 16 bits");
                }
            }
            for (int c = 0; c < width; c++) {
                greys[r * width + c] = line[c];
            }
        }
        return greys;
    }

    @Override
    public void close() {
        // the bytes are in memory
    }
}
