package org.SEAR.sensors;

/** A picture that a sensor has taken. Immutable, any thread. */
public final class Picture {
    private final int width;
    private final int height;
    private final int[] pixels;

    /**
     * A picture of pixels.
     *
     * @param width pixels of a row, 1 or more
     * @param pixels row by row from the top left, 0xRRGGBB each (sRGB); belongs to the picture from now on
     * @throws IllegalArgumentException if they make no rectangle
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

    /** Pixels of a row. */
    public int getWidth() {
        return width;
    }

    /** Rows. */
    public int getHeight() {
        return height;
    }

    /** A copy, row by row from the top left, 0xRRGGBB each (sRGB). */
    public int[] getPixels() {
        return pixels.clone();
    }
}
