// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.relief;

import org.SEAR.geometry.HeightField;

/**
 * Height field resampled to pixels that cover exactly its area, the southernmost row first: elevations and slopes at
 * the pixels' centres. 8 bytes per pixel. Immutable, any thread.
 */
public final class Relief {
    private static final int SMALLEST = 64;
    /** Passes of a running mean that approximate a Gaussian. */
    private static final int PASSES = 2;

    /** Pixels from west to east. */
    public final int width;
    /** Pixels from south to north. */
    public final int height;
    /** Minimum and maximum elevation of the pixels, metres. */
    public final double lowest;
    public final double highest;
    /** Pixel size northwards and eastwards, metres. */
    public final double stepX;
    public final double stepZ;
    private final HeightField field;
    private final float[] heights;
    private final float[] smooth;

    /**
     * @param longest maximum number of pixels of the longer side, at least 64
     * @param perPost maximum number of pixels between two posts, at least 1
     * @param detail resolution of the elevations, metres; slopes are smoothed over this length, at least over the
     *     field's spacing
     */
    public Relief(HeightField field, int longest, int perPost, double detail) {
        this.field = field;
        double extentX = (field.rows - 1) * field.spacingX;
        double extentZ = (field.columns - 1) * field.spacingZ;
        double pixel = Math.max(Math.max(extentX, extentZ) / longest,
            Math.min(field.spacingX, field.spacingZ) / perPost);
        height = pixels(extentX / pixel, longest);
        width = pixels(extentZ / pixel, longest);
        stepX = extentX / height;
        stepZ = extentZ / width;
        heights = sampled();
        float low = Float.POSITIVE_INFINITY;
        float high = Float.NEGATIVE_INFINITY;
        for (float one : heights) {
            low = Math.min(low, one);
            high = Math.max(high, one);
        }
        lowest = low;
        highest = high;
        double wide = Math.max(detail, Math.max(field.spacingX, field.spacingZ)) / 2;
        smooth = blurred((int) Math.round(wide / stepX), (int) Math.round(wide / stepZ));
    }

    private static int pixels(double wanted, int most) {
        return Math.max(Math.min(SMALLEST, most), Math.min(most, (int) Math.ceil(wanted)));
    }

    private float[] sampled() {
        float[] samples = new float[width * height];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                samples[row * width + column] = (float) field.height(x(row), z(column));
            }
        }
        return samples;
    }

    /** Returns the centre of a row of pixels, metres north. */
    public double x(int row) {
        return field.lowX + (row + 0.5) * stepX;
    }

    /** Returns the centre of a column of pixels, metres east. */
    public double z(int column) {
        return field.lowZ + (column + 0.5) * stepZ;
    }

    /** Returns the elevation of a pixel, metres. */
    public float y(int row, int column) {
        return heights[row * width + column];
    }

    /** Returns the rise per metre to the north, metres. */
    public double slopeNorth(int row, int column) {
        int south = Math.max(0, row - 1);
        int north = Math.min(height - 1, row + 1);
        return (smooth[north * width + column] - smooth[south * width + column]) / ((north - south) * stepX);
    }

    /** Returns the rise per metre to the east, metres. */
    public double slopeEast(int row, int column) {
        int west = Math.max(0, column - 1);
        int east = Math.min(width - 1, column + 1);
        return (smooth[row * width + east] - smooth[row * width + west]) / ((east - west) * stepZ);
    }

    /** Returns the root mean square slope, metres per metre. */
    public double meanSlope() {
        double sum = 0;
        int count = 0;
        for (int row = 1; row < height; row += 2) {
            for (int column = 1; column < width; column += 2) {
                double north = slopeNorth(row, column);
                double east = slopeEast(row, column);
                sum += north * north + east * east;
                count++;
            }
        }
        return Math.sqrt(sum / count);
    }

    /** Returns a new array of elevations smoothed over a radius in pixels, row by row from the south. */
    public float[] blurred(int alongX, int alongZ) {
        float[] from = heights.clone();
        if (alongX < 1 && alongZ < 1) {
            return from;
        }
        float[] to = new float[from.length];
        for (int pass = 0; pass < PASSES; pass++) {
            for (int row = 0; row < height; row++) {
                mean(from, to, row * width, 1, width, alongZ);
            }
            for (int column = 0; column < width; column++) {
                mean(to, from, column, width, height, alongX);
            }
        }
        return from;
    }

    /** Computes the running mean of a line of values. Beyond its ends, the line continues by point reflection. */
    private static void mean(float[] from, float[] to, int start, int stride, int length, int radius) {
        double sum = 0;
        for (int i = -radius; i <= radius; i++) {
            sum += beyond(from, start, stride, length, i);
        }
        for (int i = 0; i < length; i++) {
            to[start + i * stride] = (float) (sum / (2 * radius + 1));
            sum += beyond(from, start, stride, length, i + radius + 1)
                - beyond(from, start, stride, length, i - radius);
        }
    }

    private static double beyond(float[] line, int start, int stride, int length, int at) {
        int last = length - 1;
        if (at < 0) {
            return 2 * line[start] - line[start + Math.min(last, -at) * stride];
        }
        return at <= last ? line[start + at * stride] : 2 * line[start + last * stride]
            - line[start + Math.max(0, 2 * last - at) * stride];
    }
}
