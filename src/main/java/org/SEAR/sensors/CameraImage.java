// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Arrays;
import java.util.List;
import org.SEAR.POJOs.Camera;
import org.SEAR.camera.image.Blobs;
import org.SEAR.geometry.Pose;

/**
 * A picture of a camera: colours, depths or temperatures, row by row from the top left. Immutable; any thread;
 * accessors return copies.
 */
public final class CameraImage implements Reading {
    private static final int FULL = 255;
    /** Luma weights of red, green and blue (Rec. 601). */
    private static final double RED = 0.299;
    private static final double GREEN = 0.587;
    private static final double BLUE = 0.114;

    private final Camera camera;
    private final double time;
    private final Pose pose;
    private final Rays rays;
    private final int[] pixels;
    private final float[] values;
    private final double[] numbers;

    /** Directions of a camera's pixels. */
    interface Rays {
        /** Metres to the left of the axis, at one metre ahead. */
        double left(int pixel);

        /** Metres above the axis, at one metre ahead. */
        double up(int pixel);
    }

    /**
     * Creates a picture of colours or of other values.
     *
     * @param time when it was taken, simulated seconds
     * @param pose pose of the camera in the world at that time
     * @param pixels 0xRRGGBB each; null for other values; not copied
     * @param values metres or degrees Celsius; null for colours; not copied
     */
    CameraImage(Camera camera, double time, Pose pose, Rays rays, int[] pixels, float[] values) {
        this.camera = camera;
        this.time = time;
        this.pose = pose;
        this.rays = rays;
        this.pixels = pixels;
        this.values = values;
        numbers = measured();
    }

    /** Returns {@link Camera#COLOR}, {@link Camera#DEPTH} or {@link Camera#INFRARED}. */
    public String getKind() {
        return camera.getKind();
    }

    /** Returns the pixels per row. */
    public int getWidth() {
        return camera.getWidth();
    }

    /** Returns the number of rows. */
    public int getHeight() {
        return camera.getHeight();
    }

    /** Returns when it was taken, simulated seconds. */
    public double getTime() {
        return time;
    }

    /** Returns the pose of the camera in the world at that time: x left, y up, z ahead. */
    public Pose getPose() {
        return pose;
    }

    /** Returns 0xRRGGBB (sRGB) of each pixel; null for other values. */
    public int[] getPixels() {
        return pixels == null ? null : pixels.clone();
    }

    /** Returns metres along the axis, infinite without a return, or degrees Celsius; null for colours. */
    public float[] getValues() {
        return values == null ? null : values.clone();
    }

    /**
     * Returns the points of a depth picture; pixels without a return are omitted.
     *
     * @param world whether the points are in the world frame or in the camera's: x left, y up, z ahead
     * @return x, y, z of each, metres
     * @throws IllegalStateException if it is no depth picture
     */
    public float[] getPoints(boolean world) {
        if (!Camera.DEPTH.equals(getKind())) {
            throw new IllegalStateException("a picture of " + getKind() + " has no depths; use setKind(\""
                + Camera.DEPTH + "\")");
        }
        float[] points = new float[3 * values.length];
        int count = 0;
        for (int i = 0; i < values.length; i++) {
            if (values[i] < Float.POSITIVE_INFINITY) {
                double[] point = {values[i] * rays.left(i), values[i] * rays.up(i), values[i]};
                point = world ? pose.transform(point[0], point[1], point[2]) : point;
                points[count++] = (float) point[0];
                points[count++] = (float) point[1];
                points[count++] = (float) point[2];
            }
        }
        return Arrays.copyOf(points, count);
    }

    /**
     * Returns a PNG file. Colours: 8 bits per channel. Depths: 16-bit grey, millimetres, 0 without a return or beyond
     * 65.535 m. Temperatures: 16-bit grey, hundredths of a kelvin, 0 for a missing pixel.
     */
    public byte[] png() {
        return grid().png();
    }

    /** Returns the pixels without camera and pose. */
    public PixelGrid grid() {
        return new PixelGrid(getKind(), getWidth(), pixels, values);
    }

    /**
     * Returns the regions of a colour picture with the hue of a colour, largest first.
     *
     * @param color 0xRRGGBB
     * @param least minimum pixels of a region
     * @throws IllegalStateException if it is no colour picture
     */
    public List<Blobs.Blob> blobs(int color, int least) {
        if (pixels == null) {
            throw new IllegalStateException("a picture of " + getKind() + " has no colours; use setKind(\""
                + Camera.COLOR + "\")");
        }
        return Blobs.find(getWidth(), pixels, color, least);
    }

    /** Returns mean brightness, 0 to 255, of colours; the nearest depth; or the lowest and the highest temperature. */
    @Override
    public double[] numbers() {
        return numbers.clone();
    }

    private double[] measured() {
        if (pixels != null) {
            double sum = 0;
            for (int rgb : pixels) {
                sum += RED * (rgb >> 16 & FULL) + GREEN * (rgb >> 8 & FULL) + BLUE * (rgb & FULL);
            }
            return new double[] {sum / pixels.length};
        }
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (float value : values) {
            least = Math.min(least, value);
            most = Math.max(most, value);
        }
        return Camera.DEPTH.equals(getKind()) ? new double[] {least} : new double[] {least, most};
    }

    @Override
    public List<String> names() {
        return names(getKind());
    }

    /** Returns the names of the numbers of a kind of camera. */
    public static List<String> names(String kind) {
        return Camera.COLOR.equals(kind) ? List.of(".brightness") : Camera.DEPTH.equals(kind) ? List.of(".nearest")
            : List.of(".coldest", ".warmest");
    }

    /** Returns 0xRRGGBB of each pixel for colours, otherwise metres or degrees Celsius. */
    @Override
    public Object value() {
        return pixels != null ? getPixels() : getValues();
    }

    @Override
    public String words(double[] kept, String unit) {
        String size = getWidth() + " x " + getHeight() + ", ";
        if (pixels != null) {
            return size + "brightness " + ReadingWords.fixed(kept[0], 0);
        }
        if (Camera.DEPTH.equals(getKind())) {
            return size + (kept[0] < Double.POSITIVE_INFINITY ? "nearest " + ReadingWords.fixed(kept[0], 3) + " m"
                : "nothing");
        }
        return size + ReadingWords.fixed(kept[0], 1) + " to " + ReadingWords.fixed(kept[1], 1) + " degC";
    }

    /**
     * Returns the picture; depths and temperatures in false colours, from red (near or warm) to blue, black without a
     * return.
     */
    @Override
    public Picture picture() {
        return grid().picture();
    }
}
