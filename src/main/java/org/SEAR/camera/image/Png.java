// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera.image;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Encodes pictures as PNG, 8 bits per channel or 16 bits grey. Any thread. */
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

    /** @param values row by row from the top left, clamped to 0 to 65535 */
    public static byte[] ofGrey(int width, int[] values) {
        BufferedImage image = new BufferedImage(width, values.length / width, BufferedImage.TYPE_USHORT_GRAY);
        short[] shades = new short[values.length];
        for (int i = 0; i < values.length; i++) {
            shades[i] = (short) Math.max(0, Math.min(MAX_GREY, values[i]));
        }
        image.getRaster().setDataElements(0, 0, width, image.getHeight(), shades);
        return of(image);
    }

    /** Encodes a picture, including transparency. */
    public static byte[] of(BufferedImage image) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        // in memory: the default stream would use a temporary file
        try (ImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
            ImageIO.write(image, "png", out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
