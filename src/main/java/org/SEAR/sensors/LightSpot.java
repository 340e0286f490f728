// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Arrays;
import org.SEAR.POJOs.SurfaceSensor;
import org.SEAR.geometry.Pose;
import org.SEAR.raycast.Hit;

/**
 * Light reflected by a small round spot: the mean colour at the ends of parallel rays. A ray without a hit returns no
 * light. Simulation thread.
 */
final class LightSpot {
    /**
     * Rays on each ring, and the ring's radius as a fraction of the spot's. Each ray represents about the same area.
     */
    private static final int[] ON_RING = {6, 12};
    private static final double[] RADIUS = {0.45, 0.85};
    /**
     * Rotation of a ring, as a fraction of the angle between two rays, so that no ray lies on an edge straight through
     * the middle.
     */
    private static final double TURNED = 0.3;
    private static final double FULL = 255;
    /** sRGB transfer function: linear up to the knee, then a power. */
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
     * Measures the light.
     *
     * @param pose pose of the sensor in the world
     * @return red, green and blue as fractions of the incident light, 0 to 1; overwritten by the next call
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
                add(truth, pose.x + a * left[0] + b * up[0], pose.y + a * left[1] + b * up[1], pose.z + a * left[2]
                    + b * up[2], ahead);
                beams++;
            }
        }
        for (int i = 0; i < light.length; i++) {
            light[i] /= beams;
        }
        return light;
    }

    private void add(Truth truth, double x, double y, double z, double[] ahead) {
        double distance = truth.scene().cast(x, y, z, ahead[0], ahead[1], ahead[2], parameters.getRange(),
            truth.owner(), hit);
        if (distance < Double.POSITIVE_INFINITY) {
            int color = truth.color(hit.shape, x + distance * ahead[0], y + distance * ahead[1],
                z + distance * ahead[2]);
            light[0] += linear(color >> 16 & 0xFF);
            light[1] += linear(color >> 8 & 0xFF);
            light[2] += linear(color & 0xFF);
        }
    }

    /** Converts 0 to 255 (sRGB) to a fraction of light. */
    static double linear(int picture) {
        double value = picture / FULL;
        return value <= KNEE ? value / SLOPE : Math.pow((value + OFFSET) / (1 + OFFSET), GAMMA);
    }

    /** Converts a fraction of light to 0 to 255 (sRGB). */
    static double picture(double light) {
        return FULL * (light <= KNEE_LINEAR ? light * SLOPE : (1 + OFFSET) * Math.pow(light, 1 / GAMMA) - OFFSET);
    }
}
