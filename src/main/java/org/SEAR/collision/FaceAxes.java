// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Three perpendicular axes along which a mesh has most of its faces. They are the axes of its file unless others have
 * clearly more.
 */
final class FaceAxes {
    /** Sine of the largest angle between an axis and the normal of a face along it. */
    private static final double ALONG = 0.02;
    /** Steps per unit of the grid that collects similar normals. */
    private static final int STEPS = 16;
    /** Share of more area that other axes need. */
    private static final double MORE = 1.1;

    /** Unit axes in the mesh's frame, row by row. */
    private final double[] axes;

    private FaceAxes(double... axes) {
        this.axes = axes;
    }

    /**
     * @param points x, y, z of each vertex
     * @param indices three per triangle
     */
    static FaceAxes of(double[] points, int[] indices) {
        Map<Integer, double[]> sums = new LinkedHashMap<>();
        for (int i = 0; i < indices.length; i += 3) {
            double[] n = normal(points, indices, i);
            double length = length(n);
            if (length > 0) {
                double sign = Math.signum(n[0] != 0 ? n[0] : n[1] != 0 ? n[1] : n[2]);
                double[] sum = sums.computeIfAbsent(cell(n, sign / length), key -> new double[3]);
                for (int k = 0; k < 3; k++) {
                    sum[k] += sign * n[k];
                }
            }
        }
        FaceAxes own = new FaceAxes(1, 0, 0, 0, 1, 0, 0, 0, 1);
        FaceAxes other = of(sums);
        return other != null && other.area(points, indices) > MORE * own.area(points, indices) ? other : own;
    }

    private static FaceAxes of(Map<Integer, double[]> sums) {
        double[] first = largest(sums, null);
        double[] second = first == null ? null : largest(sums, first);
        if (second == null) {
            return null;
        }
        double[] third = {first[1] * second[2] - first[2] * second[1], first[2] * second[0] - first[0] * second[2],
            first[0] * second[1] - first[1] * second[0]};
        return new FaceAxes(first[0], first[1], first[2], second[0], second[1], second[2], third[0],
            third[1], third[2]);
    }

    /** Returns the direction of the largest sum; with an axis, of the largest perpendicular to it. */
    private static double[] largest(Map<Integer, double[]> sums, double[] axis) {
        double[] best = null;
        for (double[] sum : sums.values()) {
            if ((axis == null || Math.abs(dot(sum, axis)) < ALONG * length(sum))
                && (best == null || length(sum) > length(best))) {
                best = sum;
            }
        }
        if (best == null) {
            return null;
        }
        double[] unit = best.clone();
        for (int k = 0; k < 3 && axis != null; k++) {
            unit[k] -= dot(best, axis) * axis[k];
        }
        double length = length(unit);
        return new double[] {unit[0] / length, unit[1] / length, unit[2] / length};
    }

    private static int cell(double[] n, double scale) {
        int x = (int) Math.round(n[0] * scale * STEPS) + STEPS;
        int y = (int) Math.round(n[1] * scale * STEPS) + STEPS;
        int z = (int) Math.round(n[2] * scale * STEPS) + STEPS;
        return (x << 6 | y) << 6 | z;
    }

    /** Returns twice the area of the faces along the axes. */
    private double area(double[] points, int[] indices) {
        double area = 0;
        for (int i = 0; i < indices.length; i += 3) {
            double[] n = normal(points, indices, i);
            double most = 0;
            for (int k = 0; k < 9; k += 3) {
                most = Math.max(most, Math.abs(n[0] * axes[k] + n[1] * axes[k + 1] + n[2] * axes[k + 2]));
            }
            area += most > (1 - ALONG * ALONG / 2) * length(n) ? length(n) : 0;
        }
        return area;
    }

    private static double[] normal(double[] p, int[] indices, int at) {
        int a = 3 * indices[at];
        int b = 3 * indices[at + 1];
        int c = 3 * indices[at + 2];
        double ux = p[b] - p[a];
        double uy = p[b + 1] - p[a + 1];
        double uz = p[b + 2] - p[a + 2];
        double wx = p[c] - p[a];
        double wy = p[c + 1] - p[a + 1];
        double wz = p[c + 2] - p[a + 2];
        return new double[] {uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double length(double[] a) {
        return Math.sqrt(dot(a, a));
    }

    /** Returns points of the mesh's frame along these axes. */
    double[] along(double[] points) {
        return turned(points, 1, 3);
    }

    /** Returns points along these axes in the mesh's frame. */
    double[] back(double[] points) {
        return turned(points, 3, 1);
    }

    private double[] turned(double[] p, int step, int row) {
        double[] turned = new double[p.length];
        for (int i = 0; i < p.length; i += 3) {
            for (int k = 0; k < 3; k++) {
                turned[i + k] = axes[k * row] * p[i] + axes[k * row + step] * p[i + 1]
                    + axes[k * row + 2 * step] * p[i + 2];
            }
        }
        return turned;
    }
}
