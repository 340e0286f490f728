package org.SEAR.camera.image;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Pictures as PNG files, of 8 bits a channel or of 16 bits of grey. Any thread. */
public final class Png {
    private static final int MAX_GREY = 0xffff;

    private Png() {
    }

    /** @param pixels 0xRRGGBB each, row by row from the top left */
    public static byte[] ofColors(int width, int[] pixels) {
        BufferedImage image = new BufferedImage(width, pixels.length / width, BufferedImage.TYPE_INT_RGB);
        image.getRaster().setDataElements(0, 0, width, image.getHeight(), pixels);
        return of(image);
    }

    /** @param values 0 to 65535 each, row by row from the top left; lower ones become 0, higher ones 65535 */
    public static byte[] ofGrey(int width, int[] values) {
        BufferedImage image = new BufferedImage(width, values.length / width, BufferedImage.TYPE_USHORT_GRAY);
        short[] shades = new short[values.length];
        for (int i = 0; i < values.length; i++) {
            shades[i] = (short) Math.max(0, Math.min(MAX_GREY, values[i]));
        }
        image.getRaster().setDataElements(0, 0, width, image.getHeight(), shades);
        return of(image);
    }

    /** A whole picture; what can be seen through stays so. */
    public static byte[] of(BufferedImage image) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {    // in memory: else each picture is a file for a moment
            ImageIO.write(image, "png", out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
