package org.SEAR.sensors;

import java.util.Arrays;
import org.SEAR.POJOs.SurfaceSensor;
import org.SEAR.geometry.Pose;
import org.SEAR.raycast.Hit;

/**
 * The light that a small round spot throws back: the mean over parallel beams of the colour where each ends. Nothing in range throws nothing back.
 * Simulation thread.
 */
final class LightSpot {
    /** Beams on each ring, and the ring's radius as a share of the spot's: each beam stands for about as much of the spot's area. */
    private static final int[] ON_RING = {6, 12};
    private static final double[] RADIUS = {0.45, 0.85};
    /** Share of the angle between two beams by which a ring is turned, so that none lies on an edge which goes straight through the middle. */
    private static final double TURNED = 0.3;
    private static final double FULL = 255;
    /** sRGB: up to here in a straight line, then a power. */
    private static final double KNEE = 0.04045;
    private static final double KNEE_LINEAR = 0.0031308;
    private static final double SLOPE = 12.92;
    private static final double OFFSET = 0.055;
    private static final double GAMMA = 2.4;

    private final SurfaceSensor parameters;
    private final Hit hit = new Hit();
    private final double[] light = new double[3];

    LightSpot(SurfaceSensor parameters) {
        this.parameters = parameters;
    }

    /**
     * Looks.
     *
     * @param pose of the sensor in the world
     * @return red, green and blue light, 0 to 1 of what falls on the spot; changed by the next look
     */
    double[] look(Truth truth, Pose pose) {
        Arrays.fill(light, 0);
        double[] left = pose.rotate(1, 0, 0);
        double[] up = pose.rotate(0, 1, 0);
        double[] ahead = pose.rotate(0, 0, 1);
        int beams = 0;
        for (int ring = 0; ring < ON_RING.length; ring++) {
            double radius = parameters.getSpot() / 2 * RADIUS[ring];
            for (int i = 0; i < ON_RING[ring]; i++) {
                double angle = 2 * Math.PI * (i + TURNED) / ON_RING[ring];
                double a = radius * Math.cos(angle);
                double b = radius * Math.sin(angle);
                add(truth, pose.x + a * left[0] + b * up[0], pose.y + a * left[1] + b * up[1], pose.z + a * left[2] + b * up[2], ahead);
                beams++;
            }
        }
        for (int i = 0; i < light.length; i++) {
            light[i] /= beams;
        }
        return light;
    }

    private void add(Truth truth, double x, double y, double z, double[] ahead) {
        double distance = truth.scene().cast(x, y, z, ahead[0], ahead[1], ahead[2], parameters.getRange(), truth.owner(), hit);
        if (distance < Double.POSITIVE_INFINITY) {
            int color = truth.color(hit.shape, x + distance * ahead[0], y + distance * ahead[1], z + distance * ahead[2]);
            light[0] += linear(color >> 16 & 0xFF);
            light[1] += linear(color >> 8 & 0xFF);
            light[2] += linear(color & 0xFF);
        }
    }

    /** From 0 to 255 in a picture to a share of light. */
    static double linear(int picture) {
        double value = picture / FULL;
        return value <= KNEE ? value / SLOPE : Math.pow((value + OFFSET) / (1 + OFFSET), GAMMA);
    }

    /** From a share of light to 0 to 255 in a picture. */
    static double picture(double light) {
        return FULL * (light <= KNEE_LINEAR ? light * SLOPE : (1 + OFFSET) * Math.pow(light, 1 / GAMMA) - OFFSET);
    }
}
