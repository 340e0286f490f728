// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.geometry.Pose;

/** A box of a scene. Exact penetration depth of two boxes by the fifteen separating axes. */
final class Cuboid {
    final String name;
    /** Half sizes along its axes x, y and z, metres. */
    private final double[] half;
    private double[] at;
    private double[][] axes;

    Cuboid(String name, double sizeX, double sizeY, double sizeZ) {
        this.name = name;
        half = new double[] {sizeX / 2, sizeY / 2, sizeZ / 2};
    }

    /** Sets the current pose. */
    void place(Pose pose) {
        at = new double[] {pose.x, pose.y, pose.z};
        axes = new double[][] {pose.rotate(1, 0, 0), pose.rotate(0, 1, 0), pose.rotate(0, 0, 1)};
    }

    /** Returns the extent from the middle along a direction, metres times the direction's length. */
    double reach(double[] direction) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            sum += half[i] * Math.abs(dot(axes[i], direction));
        }
        return sum;
    }

    /** Returns the lower bound along an axis of the world (0 to 2), metres. */
    double low(int axis) {
        return at[axis] - reach(unit(axis));
    }

    double high(int axis) {
        return at[axis] + reach(unit(axis));
    }

    /** Returns the greatest vertical component of its axes: 1 on a face. */
    double flat() {
        return Math.max(Math.abs(axes[0][1]), Math.max(Math.abs(axes[1][1]), Math.abs(axes[2][1])));
    }

    /** Returns the penetration depth into another box, metres; 0 if they are apart. */
    double depth(Cuboid other) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 3; i++) {
            least = Math.min(least, Math.min(along(axes[i], other), along(other.axes[i], other)));
            for (int k = 0; k < 3; k++) {
                double[] axis = cross(axes[i], other.axes[k]);
                double length = Math.sqrt(dot(axis, axis));
                if (length > 1e-9) {
                    least = Math.min(least, along(axis, other) / length);
                }
            }
        }
        return Math.max(0, least);
    }

    private double along(double[] axis, Cuboid other) {
        double[] apart = {other.at[0] - at[0], other.at[1] - at[1], other.at[2] - at[2]};
        return reach(axis) + other.reach(axis) - Math.abs(dot(apart, axis));
    }

    private static double[] unit(int axis) {
        double[] unit = new double[3];
        unit[axis] = 1;
        return unit;
    }

    private static double dot(double[] u, double[] w) {
        return u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
    }

    private static double[] cross(double[] u, double[] w) {
        return new double[] {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
    }
}
