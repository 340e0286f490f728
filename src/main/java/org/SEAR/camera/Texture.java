// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

/**
 * Mipmapped texture (Williams, "Pyramidal parametrics", 1983) with anisotropic filtering: a pixel's colour is the mean
 * of a few samples along its longer side, from the level whose pixels are about as large. Mixes in integers, so that
 * the bytes are the same everywhere. Immutable, any thread.
 */
public final class Texture {
    /** Largest number of samples of a pixel at a flat angle. */
    private static final int MAX_PLACES = 4;
    /** Squared share of each sample, by number of samples. */
    private static final double[] PARTS = {1, 1, 1 / 4.0, 1 / 9.0, 1 / 16.0};
    /**
     * Steepness of the blend between two levels relative to the size; near a level only that one is sampled, which
     * halves the work.
     */
    private static final double STEEPER = 3;
    private static final int BITS = 8;
    private static final int ONE = 1 << BITS;
    /** Bound of the rounding error of a sample's position, pixels. */
    private static final double ROUNDING = 1e-3;
    private static final int MANTISSA = 52;
    private static final int BIAS = 1023;

    private final int[][] levels;
    private final int[] widths;
    private final int[] heights;
    private final boolean repeated;

    /**
     * Creates a texture.
     *
     * @param pixels 0xRRGGBB, row by row from the top left
     * @param repeated whether the texture repeats beyond its edges; otherwise its edge pixels continue
     */
    public Texture(int width, int height, int[] pixels, boolean repeated) {
        int count = 1;
        for (int size = Math.max(width, height); size > 1; size /= 2) {
            count++;
        }
        levels = new int[count][];
        widths = new int[count];
        heights = new int[count];
        levels[0] = pixels.clone();
        widths[0] = width;
        heights[0] = height;
        this.repeated = repeated;
        for (int level = 1; level < count; level++) {
            shrink(level);
        }
    }

    private void shrink(int level) {
        int width = widths[level - 1];
        int height = heights[level - 1];
        widths[level] = Math.max(1, width / 2);
        heights[level] = Math.max(1, height / 2);
        int[] from = levels[level - 1];
        int[] to = new int[widths[level] * heights[level]];
        for (int row = 0; row < heights[level]; row++) {
            int top = row * height / heights[level];
            int bottom = Math.max(top + 1, (row + 1) * height / heights[level]);
            for (int column = 0; column < widths[level]; column++) {
                int left = column * width / widths[level];
                int right = Math.max(left + 1, (column + 1) * width / widths[level]);
                to[row * widths[level] + column] = mean(from, width, left, right, top, bottom);
            }
        }
        levels[level] = to;
    }

    private static int mean(int[] pixels, int width, int left, int right, int top, int bottom) {
        int red = 0;
        int green = 0;
        int blue = 0;
        for (int row = top; row < bottom; row++) {
            for (int column = left; column < right; column++) {
                int rgb = pixels[row * width + column];
                red += rgb >> 16 & 0xff;
                green += rgb >> 8 & 0xff;
                blue += rgb & 0xff;
            }
        }
        int count = (right - left) * (bottom - top);
        return (red + count / 2) / count << 16 | (green + count / 2) / count << 8 | (blue + count / 2) / count;
    }

    /**
     * Sets the colour that a pixel sees.
     *
     * @param u 0 at the texture's left edge, 1 at its right one
     * @param v 0 at its lower edge, 1 at its upper one
     * @param ux change of u for one pixel to the right, likewise vx
     * @param uy change of u for one pixel down, likewise vy
     * @param spot takes red, green and blue
     */
    public void look(double u, double v, double ux, double vx, double uy, double vy, SurfaceHit spot) {
        double rightU = ux * widths[0];
        double rightV = vx * heights[0];
        double downU = uy * widths[0];
        double downV = vy * heights[0];
        double right = rightU * rightU + rightV * rightV;
        double down = downU * downU + downV * downV;
        double longer = Math.max(right, down);
        spot.red = 0;
        spot.green = 0;
        spot.blue = 0;
        if (!(longer > 1)) {
            add(0, u, v, 0, 0, 1, 1, spot);
            return;
        }
        double area = rightU * downV - rightV * downU;
        int places = places(longer * longer / Math.max(longer, area * area));
        double level = Math.min(levels.length - 1, logarithm(Math.max(1, longer * PARTS[places])) / 2);
        int finer = (int) level;
        double coarse = Math.max(0, Math.min(1, STEEPER * (level - finer - 0.5) + 0.5));
        double stepU = right >= down ? ux : uy;
        double stepV = right >= down ? vx : vy;
        if (coarse < 1) {
            add(finer, u, v, stepU, stepV, places, 1 - coarse, spot);
        }
        if (coarse > 0) {
            add(finer + 1, u, v, stepU, stepV, places, coarse, spot);
        }
    }

    /** @param square squared ratio of length to width of a pixel's footprint */
    private static int places(double square) {
        return square > 9 ? MAX_PLACES : square > 4 ? 3 : square > 1 ? 2 : 1;
    }

    /** Returns the logarithm to base 2 of a number of at least 1, linear between powers of 2. */
    private static double logarithm(double value) {
        long bits = Double.doubleToRawLongBits(value);
        double mantissa = Double.longBitsToDouble(bits & (1L << MANTISSA) - 1 | (long) BIAS << MANTISSA);
        return (bits >>> MANTISSA) - BIAS + mantissa - 1;
    }

    /** Adds the mean of samples in a row, each the bilinear mean of four pixels. */
    private void add(int level, double u, double v, double stepU, double stepV, int places, double share,
        SurfaceHit spot) {
        int width = widths[level];
        int height = heights[level];
        double first = 0.5 / places - 0.5;
        double across = ((repeated ? u - Math.floor(u) : u) + first * stepU) * width - 0.5;
        double down = height - 0.5 - ((repeated ? v - Math.floor(v) : v) + first * stepV) * height;
        double stepAcross = stepU * width / places;
        double stepDown = -stepV * height / places;
        double lastAcross = across + (places - 1) * stepAcross;
        double lastDown = down + (places - 1) * stepDown;
        boolean within = Math.min(across, lastAcross) >= ROUNDING && Math.max(across, lastAcross) < width - 1 - ROUNDING
            && Math.min(down, lastDown) >= ROUNDING && Math.max(down, lastDown) < height - 1 - ROUNDING;
        double scale = share / (ONE * ONE * places);
        if (within) {
            addWithin(levels[level], width, across, down, stepAcross, stepDown, places, scale, spot);
        } else {
            addAnywhere(level, across, down, stepAcross, stepDown, places, scale, spot);
        }
    }

    private void addAnywhere(int level, double firstAcross, double firstDown, double stepAcross, double stepDown,
        int places, double scale, SurfaceHit spot) {
        int width = widths[level];
        int height = heights[level];
        int[] pixels = levels[level];
        double across = firstAcross;
        double down = firstDown;
        int red = 0;
        int green = 0;
        int blue = 0;
        for (int i = 0; i < places; i++) {
            int left = floor(across);
            int top = floor(down);
            int right = (int) ((across - left) * ONE);
            int below = (int) ((down - top) * ONE);
            int x0 = inside(left, width);
            int x1 = inside(left + 1, width);
            int y0 = inside(top, height) * width;
            int y1 = inside(top + 1, height) * width;
            int a = pixels[y0 + x0];
            int b = pixels[y0 + x1];
            int c = pixels[y1 + x0];
            int d = pixels[y1 + x1];
            int wd = right * below;
            int wb = right * ONE - wd;
            int wc = below * ONE - wd;
            int wa = ONE * ONE - wb - wc - wd;
            red += (a >> 16 & 0xff) * wa + (b >> 16 & 0xff) * wb + (c >> 16 & 0xff) * wc + (d >> 16 & 0xff) * wd;
            green += (a >> 8 & 0xff) * wa + (b >> 8 & 0xff) * wb + (c >> 8 & 0xff) * wc + (d >> 8 & 0xff) * wd;
            blue += (a & 0xff) * wa + (b & 0xff) * wb + (c & 0xff) * wc + (d & 0xff) * wd;
            across += stepAcross;
            down += stepDown;
        }
        spot.red += scale * red;
        spot.green += scale * green;
        spot.blue += scale * blue;
    }

    /**
     * Does the same where no sample is at an edge. Red and blue are computed together, 32 bits apart, so that one
     * multiplication serves both: a mean of two pixels takes 16 bits, one of four 24, and the sum of
     * {@link #MAX_PLACES} of those 27.
     */
    private static void addWithin(int[] pixels, int width, double firstAcross, double firstDown, double stepAcross,
        double stepDown, int places, double scale, SurfaceHit spot) {
        // in 256ths of a pixel: their lower bits are the shares of the pixel to the right and of the one below
        double across = firstAcross * ONE;
        double down = firstDown * ONE;
        double toRight = stepAcross * ONE;
        double toBottom = stepDown * ONE;
        long redBlue = 0;
        int green = 0;
        for (int i = 0; i < places; i++) {
            int x = (int) across;
            int y = (int) down;
            int right = x & ONE - 1;
            int below = y & ONE - 1;
            int at = (y >> BITS) * width + (x >> BITS);
            int a = pixels[at];
            int b = pixels[at + 1];
            int c = pixels[at + width];
            int d = pixels[at + width + 1];
            int wd = right * below;
            int wb = right * ONE - wd;
            int wc = below * ONE - wd;
            int wa = ONE * ONE - wb - wc - wd;
            redBlue += apart(a) * wa + apart(b) * wb + apart(c) * wc + apart(d) * wd;
            green += (a >> 8 & 0xff) * wa + (b >> 8 & 0xff) * wb + (c >> 8 & 0xff) * wc + (d >> 8 & 0xff) * wd;
            across += toRight;
            down += toBottom;
        }
        spot.red += scale * (redBlue >>> 32);
        spot.green += scale * green;
        spot.blue += scale * (int) redBlue;
    }

    /** Returns red above the lower 32 bits, and blue in them. */
    private static long apart(int rgb) {
        return (long) (rgb & 0xff0000) << 16 | rgb & 0xff;
    }

    private static int floor(double value) {
        int cut = (int) value;
        return value < cut ? cut - 1 : cut;
    }

    private int inside(int at, int size) {
        if (at >= 0 && at < size) {
            return at;
        }
        return repeated ? Math.floorMod(at, size) : at < 0 ? 0 : size - 1;
    }
}
