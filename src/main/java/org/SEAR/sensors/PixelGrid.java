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
 * What a camera's picture has in its pixels: how it looks, what one pixel is in words, the file in which a record keeps it. Immutable, any thread.
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
     * Pixels, row by row from the top left; they belong to it from now on.
     *
     * @param kind {@link Camera#COLOR}, {@link Camera#DEPTH} or {@link Camera#INFRARED}
     * @param width pixels of a row
     * @param pixels 0xRRGGBB each; null for other values
     * @param values metres, infinite where nothing came back, or degrees Celsius; null for colours
     */
    PixelGrid(String kind, int width, int[] pixels, float[] values) {
        this.kind = kind;
        this.width = width;
        this.pixels = pixels;
        this.values = values;
    }

    /**
     * What {@link #file} has made.
     *
     * @throws IOException if it is no picture of that kind
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
            values[i] = grey == 0 ? depths ? Float.POSITIVE_INFINITY : Float.NaN : (float) (depths ? grey / MILLI : grey / CENTI + ABSOLUTE_ZERO);
        }
        return new PixelGrid(kind, width, null, values);
    }

    /** Looks at its size before it makes room for it: who has written the file is not known. */
    private static BufferedImage image(byte[] file, String format) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName(format).next();
        try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(file))) {
            reader.setInput(in, true, true);
            long size = (long) reader.getWidth(0) * reader.getHeight(0);
            if (size > Camera.MAX_PIXELS) {
                throw new IOException("a picture has " + size + " pixels, legal: at most " + Camera.MAX_PIXELS);
            }
            return reader.read(0);
        } catch (RuntimeException e) {      // so the JDK says of some broken files what is wrong
            throw new IOException("a picture can't be read, legal: a " + format + " file: " + e, e);
        } finally {
            reader.dispose();
        }
    }

    /** The kind of the camera. */
    public String getKind() {
        return kind;
    }

    /** Pixels of a row. */
    public int getWidth() {
        return width;
    }

    /** Rows. */
    public int getHeight() {
        return (pixels == null ? values.length : pixels.length) / width;
    }

    /** How it looks; depths and temperatures in false colours: from red, near or warm, to blue; black where there is no value. */
    public Picture picture() {
        return new Picture(width, pixels != null ? pixels.clone() : FalseColors.of(values, Camera.DEPTH.equals(kind)));
    }

    /** The least and the greatest value that the false colours show, metres or degrees Celsius; null for colours, or without any. */
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

    /** A value of the picture in words, with its unit. */
    public String words(double value) {
        return Camera.DEPTH.equals(kind) ? ReadingWords.fixed(value, 3) + " m" : ReadingWords.fixed(value, 1) + " degC";
    }

    /**
     * What one pixel sees, in words: how far it is, how warm, or of which colour.
     *
     * @param distance to what it sees, metres along the axis, which only pictures of depths know themselves; not a number if it isn't known
     * @throws IllegalArgumentException if there is no such pixel
     */
    public String words(int column, int row, double distance) {
        String reported = words(column, row);
        if (Camera.DEPTH.equals(kind) || Double.isNaN(distance)) {
            return reported;
        }
        return reported + (distance < Double.POSITIVE_INFINITY ? ", " + ReadingWords.fixed(distance, 3) + " m ahead" : ", nothing in range");
    }

    /** The same without a distance that the picture doesn't know. */
    public String words(int column, int row) {
        if (column < 0 || row < 0 || column >= width || row >= getHeight()) {
            throw new IllegalArgumentException("the pixel is " + column + ", " + row + ", legal: columns 0 to " + (width - 1) + ", rows 0 to "
                + (getHeight() - 1));
        }
        int pixel = row * width + column;
        if (pixels != null) {
            String hex = String.format(Locale.ROOT, "#%06x", pixels[pixel]);
            return hex + ", " + (hex.equals(ColorNames.hex(ColorNames.near(pixels[pixel]))) ? "" : "about ") + ColorNames.near(pixels[pixel]);
        }
        if (!Float.isFinite(values[pixel])) {
            return Camera.DEPTH.equals(kind) ? "nothing came back" : "no value";
        }
        return words(values[pixel]) + (Camera.DEPTH.equals(kind) ? " ahead" : "");
    }

    /**
     * As a file that a record keeps: colours as JPEG; depths as PNG of 16 bits of grey, millimetres, 0 where nothing came back or it is farther than
     * 65.535 m; temperatures likewise, hundredths of a kelvin above absolute zero, 0 for a pixel that is missing.
     */
    public byte[] file() {
        return pixels != null ? Jpeg.ofColors(width, pixels) : png();
    }

    /** The same without loss: colours as PNG, too. */
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
