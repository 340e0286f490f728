// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.SEAR.POJOs.Camera;
import org.SEAR.camera.image.Jpeg;
import org.SEAR.camera.image.Png;
import org.SEAR.grammar.ColorNames;

/**
 * The pixels of a camera's picture: displayed, described in words, and as a file of a record. Immutable; any thread.
 */
public final class PixelGrid {
    private static final double MILLI = 1000;
    private static final double CENTI = 100;
    private static final int MAX_GREY = 0xffff;
    private static final double ABSOLUTE_ZERO = -273.15;
    private static final int COLORS = 0xffffff;

    private final String kind;
    private final int width;
    private final int[] pixels;
    private final float[] values;

    /**
     * Pixels, row by row from the top left; not copied.
     *
     * @param kind {@link Camera#COLOR}, {@link Camera#DEPTH} or {@link Camera#INFRARED}
     * @param width pixels per row
     * @param pixels 0xRRGGBB each; null for other values
     * @param values metres, infinite without a return, or degrees Celsius; null for colours
     */
    PixelGrid(String kind, int width, int[] pixels, float[] values) {
        this.kind = kind;
        this.width = width;
        this.pixels = pixels;
        this.values = values;
    }

    /**
     * Reads a file that {@link #file} has written.
     *
     * @throws IOException if it is no picture of this kind
     */
    public static PixelGrid read(String kind, byte[] file) throws IOException {
        BufferedImage image = image(file, Camera.COLOR.equals(kind) ? "jpeg" : "png");
        int width = image.getWidth();
        int height = image.getHeight();
        if (Camera.COLOR.equals(kind)) {
            int[] colors = image.getRGB(0, 0, width, height, null, 0, width);
            for (int i = 0; i < colors.length; i++) {
                colors[i] &= COLORS;
            }
            return new PixelGrid(kind, width, colors, null);
        }
        Raster raster = image.getRaster();
        float[] values = new float[width * height];
        boolean depths = Camera.DEPTH.equals(kind);
        for (int i = 0; i < values.length; i++) {
            int grey = raster.getSample(i % width, i / width, 0);
            values[i] = grey == 0 ? depths ? Float.POSITIVE_INFINITY : Float.NaN
                : (float) (depths ? grey / MILLI : grey / CENTI + ABSOLUTE_ZERO);
        }
        return new PixelGrid(kind, width, null, values);
    }

    /** Checks the size before it allocates memory, because the file may come from any source. */
    private static BufferedImage image(byte[] file, String format) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName(format).next();
        try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(file))) {
            reader.setInput(in, true, true);
            long size = (long) reader.getWidth(0) * reader.getHeight(0);
            if (size > Camera.MAX_PIXELS) {
                throw new IOException("a picture has " + size + " pixels, legal: at most " + Camera.MAX_PIXELS);
            }
            return reader.read(0);
        } catch (RuntimeException e) {      // the JDK reports some broken files this way
            throw new IOException("a picture can't be read, legal: a " + format + " file: " + e, e);
        } finally {
            reader.dispose();
        }
    }

    /** Returns the camera's kind. */
    public String getKind() {
        return kind;
    }

    /** Returns the pixels per row. */
    public int getWidth() {
        return width;
    }

    /** Returns the number of rows. */
    public int getHeight() {
        return (pixels == null ? values.length : pixels.length) / width;
    }

    /**
     * Returns the displayed picture. Depths and temperatures have false colours, from red (near or warm) to blue, black
     * without a value.
     */
    public Picture picture() {
        return new Picture(width, pixels != null ? pixels.clone() : FalseColors.of(values, Camera.DEPTH.equals(kind)));
    }

    /**
     * Returns the lowest and highest value of the false colours, metres or degrees Celsius; null for colours, or
     * without any value.
     */
    public double[] range() {
        if (values == null) {
            return null;
        }
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (float value : values) {
            if (Float.isFinite(value)) {
                least = Math.min(least, value);
                most = Math.max(most, value);
            }
        }
        return most >= least ? new double[] {least, most} : null;
    }

    /** Returns a value of the picture in words, with its unit. */
    public String words(double value) {
        return Camera.DEPTH.equals(kind) ? ReadingWords.fixed(value, 3) + " m" : ReadingWords.fixed(value, 1) + " degC";
    }

    /**
     * Describes a pixel in words: depth, temperature or colour.
     *
     * @param distance metres along the axis, which only depth pictures contain themselves; NaN if unknown
     * @throws IllegalArgumentException for a pixel outside the picture
     */
    public String words(int column, int row, double distance) {
        String reported = words(column, row);
        if (Camera.DEPTH.equals(kind) || Double.isNaN(distance)) {
            return reported;
        }
        return reported + (distance < Double.POSITIVE_INFINITY ? ", " + ReadingWords.fixed(distance, 3) + " m ahead"
            : ", nothing in range");
    }

    /** Describes a pixel without a distance from elsewhere. */
    public String words(int column, int row) {
        if (column < 0 || row < 0 || column >= width || row >= getHeight()) {
            throw new IllegalArgumentException("the pixel is " + column + ", " + row + ", legal: columns 0 to "
                + (width - 1) + ", rows 0 to " + (getHeight() - 1));
        }
        int pixel = row * width + column;
        if (pixels != null) {
            String hex = String.format(Locale.ROOT, "#%06x", pixels[pixel]);
            return hex + ", " + (hex.equals(ColorNames.hex(ColorNames.near(pixels[pixel]))) ? "" : "about ")
                + ColorNames.near(pixels[pixel]);
        }
        if (!Float.isFinite(values[pixel])) {
            return Camera.DEPTH.equals(kind) ? "no return" : "no value";
        }
        return words(values[pixel]) + (Camera.DEPTH.equals(kind) ? " ahead" : "");
    }

    /**
     * Returns the file for a record. Colours: JPEG. Depths: PNG, 16-bit grey, millimetres, 0 without a return or beyond
     * 65.535 m. Temperatures: PNG, 16-bit grey, hundredths of a kelvin, 0 for a missing pixel.
     */
    public byte[] file() {
        return pixels != null ? Jpeg.ofColors(width, pixels) : png();
    }

    /** Returns a lossless file: PNG for colours, too. */
    public byte[] png() {
        if (pixels != null) {
            return Png.ofColors(width, pixels);
        }
        boolean depths = Camera.DEPTH.equals(kind);
        int[] grey = new int[values.length];
        for (int i = 0; i < grey.length; i++) {
            double value = depths ? values[i] * MILLI : (values[i] - ABSOLUTE_ZERO) * CENTI;
            grey[i] = value >= 0 && value < MAX_GREY + 0.5 ? (int) Math.round(value) : 0;
        }
        return Png.ofGrey(width, grey);
    }
}
