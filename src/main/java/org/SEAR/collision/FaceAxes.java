// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.LinkedHashMap;
import java.util.Map;
import org.SEAR.geometry.Vec3;

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
        Map<Integer, Vec3> sums = new LinkedHashMap<>();
        Vec3 n = new Vec3();
        for (int i = 0; i < indices.length; i += 3) {
            setNormal(n, points, indices, i);
            double length = n.length();
            if (length > 0) {
                double sign = Math.signum(n.x != 0 ? n.x : n.y != 0 ? n.y : n.z);
                sums.computeIfAbsent(cell(n, sign / length), key -> new Vec3()).add(sign, n);
            }
        }
        FaceAxes own = new FaceAxes(1, 0, 0, 0, 1, 0, 0, 0, 1);
        FaceAxes other = of(sums);
        return other != null && other.area(points, indices) > MORE * own.area(points, indices) ? other : own;
    }

    private static FaceAxes of(Map<Integer, Vec3> sums) {
        Vec3 first = largest(sums, null);
        Vec3 second = first == null ? null : largest(sums, first);
        if (second == null) {
            return null;
        }
        Vec3 third = new Vec3().cross(first, second);
        return new FaceAxes(first.x, first.y, first.z, second.x, second.y, second.z, third.x, third.y, third.z);
    }

    /** Returns the direction of the largest sum; with an axis, of the largest perpendicular to it. */
    private static Vec3 largest(Map<Integer, Vec3> sums, Vec3 axis) {
        Vec3 best = null;
        for (Vec3 sum : sums.values()) {
            if ((axis == null || Math.abs(sum.dot(axis)) < ALONG * sum.length())
                && (best == null || sum.length() > best.length())) {
                best = sum;
            }
        }
        if (best == null) {
            return null;
        }
        Vec3 unit = new Vec3().set(best);
        if (axis != null) {
            unit.flatten(axis);
        }
        double length = unit.length();
        return unit.set(unit.x / length, unit.y / length, unit.z / length);
    }

    private static int cell(Vec3 n, double scale) {
        int x = (int) Math.round(n.x * scale * STEPS) + STEPS;
        int y = (int) Math.round(n.y * scale * STEPS) + STEPS;
        int z = (int) Math.round(n.z * scale * STEPS) + STEPS;
        return (x << 6 | y) << 6 | z;
    }

    /** Returns twice the area of the faces along the axes. */
    private double area(double[] points, int[] indices) {
        double area = 0;
        Vec3 n = new Vec3();
        for (int i = 0; i < indices.length; i += 3) {
            setNormal(n, points, indices, i);
            double most = 0;
            for (int k = 0; k < 9; k += 3) {
                most = Math.max(most, Math.abs(n.x * axes[k] + n.y * axes[k + 1] + n.z * axes[k + 2]));
            }
            area += most > (1 - ALONG * ALONG / 2) * n.length() ? n.length() : 0;
        }
        return area;
    }

    /** Sets the normal of a triangle, as long as twice its area. */
    private static void setNormal(Vec3 normal, double[] p, int[] indices, int at) {
        int a = 3 * indices[at];
        int b = 3 * indices[at + 1];
        int c = 3 * indices[at + 2];
        double ux = p[b] - p[a];
        double uy = p[b + 1] - p[a + 1];
        double uz = p[b + 2] - p[a + 2];
        double wx = p[c] - p[a];
        double wy = p[c + 1] - p[a + 1];
        double wz = p[c + 2] - p[a + 2];
        normal.set(uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx);
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
