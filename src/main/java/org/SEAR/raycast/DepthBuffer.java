// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import java.util.Arrays;

/**
 * Nearest hit of each ray of a fan: a one-dimensional depth buffer (Catmull 1974). Stores inverse distances because
 * along a straight line in the fan's plane the inverse distance is linear in the ray's direction: 1 / t = a * x + b *
 * z. The lower shape number wins a tie, so the order of shapes does not matter.
 */
final class DepthBuffer {
    private static final int TABLES = 4;
    private final FanDirections[] tables = new FanDirections[TABLES];
    private int nextTable;

    FanDirections beams;
    double[] inverse = new double[0];
    int[] shape = new int[0];

    void start(double startAngle, double step, int count, double maxRange) {
        beams = table(startAngle, step, count);
        if (inverse.length < count) {
            inverse = new double[count];
            shape = new int[count];
        }
        Arrays.fill(inverse, 0, count, Math.max(0, Math.nextDown(1 / maxRange * (1 - 1e-15))));
        Arrays.fill(shape, 0, count, -1);
    }

    private FanDirections table(double startAngle, double step, int count) {
        for (FanDirections known : tables) {
            if (known != null && known.is(startAngle, step, count)) {
                return known;
            }
        }
        FanDirections made = new FanDirections(startAngle, step, count);
        tables[nextTable] = made;
        nextTable = (nextTable + 1) % TABLES;
        return made;
    }

    /** Records a hit of a ray at a distance, which may be infinite. */
    void intersect(int beam, double distance, int shapeNumber) {
        double value = distance <= 0 ? Double.POSITIVE_INFINITY : 1 / distance;
        if (value > inverse[beam] || value == inverse[beam] && shapeNumber < shape[beam]) {
            inverse[beam] = value;
            shape[beam] = shapeNumber;
        }
    }

    /**
     * Draws the line from p to q, which is to the left of p, into the rays from p up to before q.
     * @param a inverse distance = a * x + b * z
     */
    void line(double px, double pz, double qx, double qz, double a, double b, int shapeNumber) {
        int first = beams.first(px, pz);
        fill(first, qx, qz, a, b, shapeNumber);
        if (first != 0 && beams.side(0, px, pz) <= 0 && beams.side(0, qx, qz) > 0) {
            fill(0, qx, qz, a, b, shapeNumber);
        }
    }

    private void fill(int first, double qx, double qz, double a, double b, int shapeNumber) {
        double[] x = beams.x;
        double[] z = beams.z;
        double[] seen = inverse;
        int count = beams.count;
        for (int i = first; i < count && z[i] * qx - x[i] * qz > 0; i++) {
            double value = a * x[i] + b * z[i];
            if (value > seen[i]) {
                seen[i] = value;
                shape[i] = shapeNumber;
            } else if (value == seen[i] && shapeNumber < shape[i]) {
                shape[i] = shapeNumber;
            }
        }
    }

    /** Draws the line of inverse distances a * x + b * z into the rays from first up to before end. */
    void fill(int first, int end, double a, double b, int shapeNumber) {
        for (int i = first; i < end; i++) {
            double value = a * beams.x[i] + b * beams.z[i];
            if (value > inverse[i] || value == inverse[i] && shapeNumber < shape[i]) {
                inverse[i] = value;
                shape[i] = shapeNumber;
            }
        }
    }

    /** Returns whether any ray from one to another has no hit nearer than an inverse distance. */
    boolean open(int from, int to, double enough) {
        for (int i = from; i <= to; i++) {
            if (inverse[i] <= enough) {
                return true;
            }
        }
        return false;
    }
}
