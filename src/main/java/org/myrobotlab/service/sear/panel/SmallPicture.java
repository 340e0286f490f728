// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Base64;
import javax.imageio.ImageIO;
import org.SEAR.camera.image.Jpeg;
import org.SEAR.camera.image.Png;
import org.SEAR.sensors.Picture;

/** Encodes pictures for pages, small enough for one message. */
final class SmallPicture {
    private static final String DATA = "data:image/";
    /** Longer side, pixels. */
    private static final int LONGEST = 512;
    /** Most characters of a data address. */
    private static final int MOST = 400_000;
    private static final double SMALLER = 0.7;
    /** Pixels of the longer side up to which a sensor's picture keeps its size; below, the most for larger ones. */
    private static final int EXACT = 64;
    private static final int LONGEST_OF_SENSOR = 320;

    private SmallPicture() {
    }

    /**
     * Returns a project's picture as a data address, at most 512 pixels long; keeps transparency.
     *
     * @param bytes the file, after a check of its size
     * @param path path for the error
     * @throws IOException if the format is none of PNG, JPEG, GIF and BMP
     */
    static String of(byte[] bytes, String path) throws IOException {
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(bytes));
        if (image == null) {
            throw new IOException(path + " appears only in the simulator window, legal on pages: .png, .jpg, "
                + ".gif or .bmp");
        }
        int longest = Math.min(LONGEST, Math.max(image.getWidth(), image.getHeight()));
        while (true) {
            String address = of(image, longest);
            if (address.length() <= MOST) {
                return address;
            }
            longest *= SMALLER;
        }
    }

    private static String of(BufferedImage image, int longest) {
        double scale = (double) longest / Math.max(image.getWidth(), image.getHeight());
        boolean solid = !image.getColorModel().hasAlpha();
        BufferedImage small = new BufferedImage(Math.max(1, (int) (image.getWidth() * scale)),
            Math.max(1, (int) (image.getHeight() * scale)),
            solid ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB);
        Graphics2D pen = small.createGraphics();
        pen.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        pen.drawImage(image, 0, 0, small.getWidth(), small.getHeight(), null);
        pen.dispose();
        return solid ? address("jpeg", Jpeg.of(small)) : address("png", Png.of(small));
    }

    /** Returns the data address of a picture's file. */
    static String address(String format, byte[] bytes) {
        return DATA + format + ";base64," + Base64.getEncoder().encodeToString(bytes);
    }

    /** Returns a sensor's picture: small ones unchanged, larger ones reduced, because panels get them repeatedly. */
    static String of(Picture picture) {
        return of(picture, LONGEST_OF_SENSOR);
    }

    /**
     * Returns a sensor's picture.
     *
     * @param most pixels of the longer side of a large picture
     */
    static String of(Picture picture, int most) {
        BufferedImage image = new BufferedImage(picture.getWidth(), picture.getHeight(), BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, picture.getWidth(), picture.getHeight(), picture.getPixels(), 0, picture.getWidth());
        int longest = Math.max(picture.getWidth(), picture.getHeight());
        return longest <= EXACT ? address("png", Png.of(image)) : of(image, Math.min(most, longest));
    }
}
