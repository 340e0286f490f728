package org.SEAR.terrain.format;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.SEAR.project.models.ModelLimits;
import org.SEAR.project.models.UnreadablePicture;

/** A picture of 8 or 16 bits whose greys are heights: black the lowest, white the highest. It has no place on Earth. */
final class GreyPicture extends ElevationMap {
    private final Raster raster;

    private GreyPicture(String name, Raster raster, int bits) {
        super(name, raster.getHeight(), raster.getWidth(), null, Math.pow(2, bits) - 1);
        this.raster = raster;
    }

    /** Unpacks a picture whose size was checked. */
    static GreyPicture open(MapBytes file) throws IOException {
        ModelLimits.range(file.getName(), "the file's size", file.size(), 1, MapBytes.MAX_UNPACKED);
        byte[] bytes = file.read("the picture", 0, (int) file.size());
        file.close();
        BufferedImage image = unpacked(file.getName(), bytes);
        ModelLimits.range(file.getName(), "the number of pixels", (long) image.getWidth() * image.getHeight(), 4, MapLimits.MAX_POSTS);
        if (image.getWidth() < 2 || image.getHeight() < 2) {
            throw ModelLimits.wrong(file.getName(), "the size", image.getHeight() + " x " + image.getWidth(), "at least 2 x 2 pixels");
        }
        if (image.getColorModel() instanceof IndexColorModel) {
            throw ModelLimits.wrong(file.getName(), "the picture", "one with a palette", "greys of 8 or 16 bits");
        }
        int bits = image.getSampleModel().getSampleSize(0);
        if (bits != 8 && bits != 16) {
            throw ModelLimits.wrong(file.getName(), "the picture's depth", bits + " bits", "8 or 16 bits of grey");
        }
        return new GreyPicture(file.getName(), image.getRaster(), bits);
    }

    private static BufferedImage unpacked(String name, byte[] bytes) throws IOException {
        try {
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(bytes));
            if (image != null) {
                return image;
            }
        } catch (RuntimeException | IOException e) {
            throw new UnreadablePicture(name + ": the picture is broken (" + e.getMessage() + "), legal: a whole picture", e);
        }
        throw new UnreadablePicture(name + ": the picture is in no known format, legal: PNG, JPEG, GIF or BMP", null);
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
                    throw ModelLimits.wrong(name, "the picture", "coloured (row " + (row + r) + ")", "greys of 8 or 16 bits");
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
        // the file was closed when it was read
    }
}
