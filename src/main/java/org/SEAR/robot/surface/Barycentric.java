// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.surface;

/**
 * Barycentric coordinates of points in mesh triangles, for interpolation between corners (Ericson, "Real-time collision
 * detection", 2005, sections 3.4 and 5.1.5).
 */
final class Barycentric {
    private Barycentric() {
    }

    /**
     * Computes the weights of a triangle's corners at a point, clamped to the triangle.
     * @param positions x, y, z of each vertex, metres
     * @param indices of the triangles' corners
     * @param first offset of the triangle's three indices
     * @param point x, y, z, metres
     * @param weights takes the three, which add up to 1
     * @return squared distance from the point to that point of the triangle, m^2; infinite for a triangle without area
     */
    static double of(float[] positions, int[] indices, int first, double[] point, double[] weights) {
        int a = 3 * indices[first];
        int b = 3 * indices[first + 1];
        int c = 3 * indices[first + 2];
        double bb = dot(positions, b, a, b);
        double bc = dot(positions, b, a, c);
        double cc = dot(positions, c, a, c);
        double area = bb * cc - bc * bc;
        if (!(area > 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double pb = along(positions, a, b, point);
        double pc = along(positions, a, c, point);
        weights[1] = Math.max(0, (cc * pb - bc * pc) / area);
        weights[2] = Math.max(0, (bb * pc - bc * pb) / area);
        double over = Math.max(1, weights[1] + weights[2]);
        weights[1] /= over;
        weights[2] /= over;
        weights[0] = 1 - weights[1] - weights[2];
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double off = point[i] - weights[0] * positions[a + i] - weights[1] * positions[b + i]
                - weights[2] * positions[c + i];
            sum += off * off;
        }
        return sum;
    }

    /** (p - a) * (q - a). */
    private static double dot(float[] at, int p, int a, int q) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            sum += ((double) at[p + i] - at[a + i]) * ((double) at[q + i] - at[a + i]);
        }
        return sum;
    }

    /** (point - a) * (p - a). */
    private static double along(float[] at, int a, int p, double[] point) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            sum += (point[i] - at[a + i]) * ((double) at[p + i] - at[a + i]);
        }
        return sum;
    }
}
