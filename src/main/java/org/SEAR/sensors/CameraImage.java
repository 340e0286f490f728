package org.SEAR.sensors;

import java.util.Arrays;
import java.util.List;
import org.SEAR.POJOs.Camera;
import org.SEAR.camera.image.Blobs;
import org.SEAR.geometry.Pose;

/**
 * A picture of a camera: colours, depths or temperatures, row by row from the top left. Immutable, any thread: what it hands out are copies.
 */
public final class CameraImage implements Reading {
    private static final int FULL = 255;
    /** As the eye weighs red, green and blue in a picture (Rec. 601). */
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

    /** Where the pixels of a camera look. */
    interface Rays {
        /** Metres to the left of the axis, one metre ahead. */
        double left(int pixel);

        /** Metres above the axis, one metre ahead. */
        double up(int pixel);
    }

    /**
     * A picture of colours, or of other values.
     *
     * @param time simulated seconds at which it was taken
     * @param pose of the camera in the world then
     * @param pixels 0xRRGGBB each; null for other values; belong to it from now on
     * @param values metres or degrees Celsius; null for colours; belong to it from now on
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

    /** {@link Camera#COLOR}, {@link Camera#DEPTH} or {@link Camera#INFRARED}. */
    public String getKind() {
        return camera.getKind();
    }

    /** Pixels of a row. */
    public int getWidth() {
        return camera.getWidth();
    }

    /** Rows. */
    public int getHeight() {
        return camera.getHeight();
    }

    /** Simulated seconds at which it was taken. */
    public double getTime() {
        return time;
    }

    /** Where the camera was in the world then: x to the left, y up, z ahead. */
    public Pose getPose() {
        return pose;
    }

    /** 0xRRGGBB (sRGB) of each pixel; null for a picture of other values. */
    public int[] getPixels() {
        return pixels == null ? null : pixels.clone();
    }

    /** Metres along the axis, infinite where nothing came back, or degrees Celsius; null for a picture of colours. */
    public float[] getValues() {
        return values == null ? null : values.clone();
    }

    /**
     * The points at which a picture of depths ends, without those where nothing came back.
     *
     * @param world whether they are points of the world, or of the camera: x to the left, y up, z ahead
     * @return x, y, z of each, metres
     * @throws IllegalStateException if it is no picture of depths
     */
    public float[] getPoints(boolean world) {
        if (!Camera.DEPTH.equals(getKind())) {
            throw new IllegalStateException("a picture of " + getKind() + " has no depths; setKind(\"" + Camera.DEPTH + "\") makes a camera of them");
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
     * The picture as a PNG file: colours of 8 bits a channel; depths as 16 bits of grey, millimetres, 0 where nothing came back or it is farther than
     * 65.535 m; temperatures as 16 bits of grey, hundredths of a kelvin above absolute zero, 0 for a pixel that is missing.
     */
    public byte[] png() {
        return grid().png();
    }

    /** What its pixels have, apart from camera and place. */
    public PixelGrid grid() {
        return new PixelGrid(getKind(), getWidth(), pixels, values);
    }

    /**
     * The pieces of a picture of colours that have the hue of a colour, the largest first.
     *
     * @param color 0xRRGGBB
     * @param least pixels that a piece has at least
     * @throws IllegalStateException if it is no picture of colours
     */
    public List<Blobs.Blob> blobs(int color, int least) {
        if (pixels == null) {
            throw new IllegalStateException("a picture of " + getKind() + " has no colours; setKind(\"" + Camera.COLOR
                + "\") makes a camera of them");
        }
        return Blobs.find(getWidth(), pixels, color, least);
    }

    /** Of colours the mean brightness, 0 to 255; of depths the nearest; of temperatures the lowest and the highest. */
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

    /** What the numbers of cameras of a kind are called. */
    public static List<String> names(String kind) {
        return Camera.COLOR.equals(kind) ? List.of(".brightness") : Camera.DEPTH.equals(kind) ? List.of(".nearest") : List.of(".coldest", ".warmest");
    }

    /** Of colours the pixels, 0xRRGGBB each; else the metres or degrees Celsius. */
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
            return size + (kept[0] < Double.POSITIVE_INFINITY ? "nearest " + ReadingWords.fixed(kept[0], 3) + " m" : "nothing");
        }
        return size + ReadingWords.fixed(kept[0], 1) + " to " + ReadingWords.fixed(kept[1], 1) + " degC";
    }

    /** Depths and temperatures in false colours: from red, near or warm, to blue; black where nothing came back. */
    @Override
    public Picture picture() {
        return grid().picture();
    }
}
