package org.SEAR.terrain.relief;

import org.SEAR.geometry.HeightField;

/**
 * A height field as a raster of pixels that covers just its area, the southernmost row first: heights at the pixels' centres, and how steep it is
 * there. Holds 8 bytes a pixel. Immutable, any thread.
 */
public final class Relief {
    private static final int SMALLEST = 64;
    /** Passes of a mean that come close to a bell curve. */
    private static final int PASSES = 2;

    /** Pixels from west to east. */
    public final int width;
    /** Pixels from south to north. */
    public final int height;
    /** The lowest and the highest height of a pixel, metres. */
    public final double lowest;
    public final double highest;
    /** Metres from pixel to pixel, northwards and eastwards. */
    public final double stepX;
    public final double stepZ;
    private final HeightField field;
    private final float[] heights;
    private final float[] smooth;

    /**
     * @param longest pixels of the longer side at most, at least 64
     * @param perPost pixels between two posts at most, at least 1
     * @param detail metres below which the heights tell nothing: slopes are smoothed over so much; the field's spacing at least
     */
    public Relief(HeightField field, int longest, int perPost, double detail) {
        this.field = field;
        double extentX = (field.rows - 1) * field.spacingX;
        double extentZ = (field.columns - 1) * field.spacingZ;
        double pixel = Math.max(Math.max(extentX, extentZ) / longest, Math.min(field.spacingX, field.spacingZ) / perPost);
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

    /** Where the centre of a row of pixels lies, metres north. */
    public double x(int row) {
        return field.lowX + (row + 0.5) * stepX;
    }

    /** Where the centre of a column of pixels lies, metres east. */
    public double z(int column) {
        return field.lowZ + (column + 0.5) * stepZ;
    }

    /** Metres. */
    public float y(int row, int column) {
        return heights[row * width + column];
    }

    /** Metres up for a metre north. */
    public double slopeNorth(int row, int column) {
        int south = Math.max(0, row - 1);
        int north = Math.min(height - 1, row + 1);
        return (smooth[north * width + column] - smooth[south * width + column]) / ((north - south) * stepX);
    }

    /** Metres up for a metre east. */
    public double slopeEast(int row, int column) {
        int west = Math.max(0, column - 1);
        int east = Math.min(width - 1, column + 1);
        return (smooth[row * width + east] - smooth[row * width + west]) / ((east - west) * stepZ);
    }

    /** The root of the mean square of the slope, metres a metre. */
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

    /** The heights smoothed over so many pixels to each side, row by row from the south. The caller's own. */
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

    /** The running mean of a line of values over radius to each side; beyond its ends the line goes on straight, turned about them. */
    private static void mean(float[] from, float[] to, int start, int stride, int length, int radius) {
        double sum = 0;
        for (int i = -radius; i <= radius; i++) {
            sum += beyond(from, start, stride, length, i);
        }
        for (int i = 0; i < length; i++) {
            to[start + i * stride] = (float) (sum / (2 * radius + 1));
            sum += beyond(from, start, stride, length, i + radius + 1) - beyond(from, start, stride, length, i - radius);
        }
    }

    private static double beyond(float[] line, int start, int stride, int length, int at) {
        int last = length - 1;
        if (at < 0) {
            return 2 * line[start] - line[start + Math.min(last, -at) * stride];
        }
        return at <= last ? line[start + at * stride] : 2 * line[start + last * stride] - line[start + Math.max(0, 2 * last - at) * stride];
    }
}
