// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.link;

import org.SEAR.sensors.CameraImage;
import org.SEAR.sensors.Picture;

/** A camera's picture, scaled down for the window. Immutable, any thread. */
public final class CameraFrame {
    /** Maximum length of the longer side, pixels. */
    public static final int LONGEST = 320;
    private static final int BYTE = 0xff;

    /** Full name of the camera. */
    public final String camera;
    /** The camera's reading as text. */
    public final String words;
    /** Width, pixels. */
    public final int width;
    /** Height, pixels. */
    public final int height;
    private final int[] pixels;

    /**
     * Creates a frame.
     * @param pixels 0xRRGGBB each, row by row from the top left; not copied
     * @throws IllegalArgumentException if a side exceeds {@link #LONGEST}, or the number of pixels doesn't match the
     *     size
     */
    public CameraFrame(String camera, String words, int width, int height, int... pixels) {
        if (width < 1 || height < 1 || width > LONGEST || height > LONGEST || pixels.length != width * height) {
            throw new IllegalArgumentException("a picture of " + width + " x " + height + " with " + pixels.length
                + " pixels, legal: 1 x 1 to " + LONGEST + " x " + LONGEST);
        }
        this.camera = camera;
        this.words = words;
        this.width = width;
        this.height = height;
        this.pixels = pixels;
    }

    /** Scales down a camera's picture by averaging pixels. Smaller pictures keep their size. */
    public static CameraFrame of(String camera, CameraImage image) {
        Picture picture = image.picture();
        int[] all = picture.getPixels();
        int across = picture.getWidth();
        int down = picture.getHeight();
        int longest = Math.max(across, down);
        int width = longest <= LONGEST ? across : Math.max(1, across * LONGEST / longest);
        int height = longest <= LONGEST ? down : Math.max(1, down * LONGEST / longest);
        int[] small = new int[width * height];
        for (int row = 0; row < height; row++) {
            int top = row * down / height;
            int rows = Math.max(1, (row + 1) * down / height - top);
            for (int column = 0; column < width; column++) {
                int left = column * across / width;
                small[row * width + column] = mean(
                    all, across, left, Math.max(1, (column + 1) * across / width - left), top, rows);
            }
        }
        return new CameraFrame(camera, image.words(""), width, height, small);
    }

    private static int mean(int[] all, int across, int left, int columns, int top, int rows) {
        int red = 0;
        int green = 0;
        int blue = 0;
        for (int row = top; row < top + rows; row++) {
            for (int column = left; column < left + columns; column++) {
                int rgb = all[row * across + column];
                red += rgb >> 16 & BYTE;
                green += rgb >> 8 & BYTE;
                blue += rgb & BYTE;
            }
        }
        int count = rows * columns;
        return red / count << 16 | green / count << 8 | blue / count;
    }

    /** Returns a pixel, 0xRRGGBB. */
    public int pixel(int column, int row) {
        return pixels[row * width + column];
    }
}
