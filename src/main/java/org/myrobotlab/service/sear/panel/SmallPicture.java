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

/** Pictures in the form that pages show, small enough for one message. */
final class SmallPicture {
    private static final String DATA = "data:image/";
    /** Pixels of the longer side. */
    private static final int LONGEST = 512;
    /** Characters of an address. */
    private static final int MOST = 400_000;
    private static final double SMALLER = 0.7;
    /** Of a sensor's picture: pixels of the longer side up to which each is shown as it is, and of a larger one that is shown. */
    private static final int EXACT = 64;
    private static final int LONGEST_OF_SENSOR = 320;

    private SmallPicture() {
    }

    /**
     * A picture of a project, at most 512 pixels long, as an address of its own; what can be seen through stays so.
     *
     * @param bytes whose size was checked
     * @param path for the error
     * @throws IOException if it is of another format than PNG, JPEG, GIF or BMP
     */
    static String of(byte[] bytes, String path) throws IOException {
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(bytes));
        if (image == null) {
            throw new IOException(path + " is shown in the window only, legal in pages: .png, .jpg, .gif or .bmp");
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
        BufferedImage small = new BufferedImage(Math.max(1, (int) (image.getWidth() * scale)), Math.max(1, (int) (image.getHeight() * scale)),
            solid ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB);
        Graphics2D pen = small.createGraphics();
        pen.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        pen.drawImage(image, 0, 0, small.getWidth(), small.getHeight(), null);
        pen.dispose();
        return solid ? address("jpeg", Jpeg.of(small)) : address("png", Png.of(small));
    }

    /** What a page takes as the address of a picture. */
    static String address(String format, byte[] bytes) {
        return DATA + format + ";base64," + Base64.getEncoder().encodeToString(bytes);
    }

    /** The picture of a sensor: each pixel of a small one as it is, larger ones smaller than they are, because they come again and again. */
    static String of(Picture picture) {
        return of(picture, LONGEST_OF_SENSOR);
    }

    /**
     * The same.
     *
     * @param most pixels of the longer side of a large one
     */
    static String of(Picture picture, int most) {
        BufferedImage image = new BufferedImage(picture.getWidth(), picture.getHeight(), BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, picture.getWidth(), picture.getHeight(), picture.getPixels(), 0, picture.getWidth());
        int longest = Math.max(picture.getWidth(), picture.getHeight());
        return longest <= EXACT ? address("png", Png.of(image)) : of(image, Math.min(most, longest));
    }
}
