// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/** A picture taken by a sensor. Immutable; any thread. */
public final class Picture {
    private final int width;
    private final int height;
    private final int[] pixels;

    /**
     * Creates a picture.
     *
     * @param width pixels per row, 1 or more
     * @param pixels row by row from the top left, 0xRRGGBB each (sRGB); not copied
     * @throws IllegalArgumentException if they form no rectangle
     */
    public Picture(int width, int... pixels) {
        if (width < 1 || pixels.length == 0 || pixels.length % width != 0) {
            throw new IllegalArgumentException("a picture of " + pixels.length + " pixels in rows of " + width
                + ", legal: one row or more of 1 pixel or more, all of the same width");
        }
        this.width = width;
        this.height = pixels.length / width;
        this.pixels = pixels;
    }

    /** Returns the pixels per row. */
    public int getWidth() {
        return width;
    }

    /** Returns the number of rows. */
    public int getHeight() {
        return height;
    }

    /** Returns a copy, row by row from the top left, 0xRRGGBB each (sRGB). */
    public int[] getPixels() {
        return pixels.clone();
    }
}
