// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/**
 * Mutable rotation matrix between an inner and an outer frame, set at each step without allocation. Not thread-safe.
 */
public final class Rotation {
    /** Half angle between two attitudes below which linear interpolation is exact. */
    private static final double SMALL = 1e-9;

    public double xx;
    public double xy;
    public double xz;
    public double yx;
    public double yy;
    public double yz;
    public double zx;
    public double zy;
    public double zz;

    public Rotation set(Pose pose) {
        return set(pose.qx, pose.qy, pose.qz, pose.qw);
    }

    /** Sets the rotation of a quaternion of any length but 0. */
    public Rotation set(double qx, double qy, double qz, double qw) {
        double s = 2 / (qx * qx + qy * qy + qz * qz + qw * qw);
        xx = 1 - s * (qy * qy + qz * qz);
        xy = s * (qx * qy - qz * qw);
        xz = s * (qx * qz + qy * qw);
        yx = s * (qx * qy + qz * qw);
        yy = 1 - s * (qx * qx + qz * qz);
        yz = s * (qy * qz - qx * qw);
        zx = s * (qx * qz - qy * qw);
        zy = s * (qy * qz + qx * qw);
        zz = 1 - s * (qx * qx + qy * qy);
        return this;
    }

    /**
     * Sets the rotation between those of two unit quaternions, at constant angular velocity (spherical linear
     * interpolation).
     *
     * @param part 0 for the first, 1 for the second quaternion; beyond 1 the rotation continues
     */
    public Rotation between(double ax, double ay, double az, double aw, double bx, double by, double bz, double bw,
        double part) {
        double sign = ax * bx + ay * by + az * bz + aw * bw < 0 ? -1 : 1;
        double half = 2 * Math.atan2(length(ax - sign * bx, ay - sign * by, az - sign * bz, aw - sign * bw),
            length(ax + sign * bx, ay + sign * by, az + sign * bz, aw + sign * bw));
        double sine = Math.sin(half);
        double ofA = half < SMALL ? 1 - part : Math.sin((1 - part) * half) / sine;
        double ofB = sign * (half < SMALL ? part : Math.sin(part * half) / sine);
        return set(ofA * ax + ofB * bx, ofA * ay + ofB * by, ofA * az + ofB * bz, ofA * aw + ofB * bw);
    }

    private static double length(double x, double y, double z, double w) {
        return Math.sqrt(x * x + y * y + z * z + w * w);
    }

    /** Writes the matrix, row by row, to the first nine numbers. */
    public void write(double[] out) {
        out[0] = xx;
        out[1] = xy;
        out[2] = xz;
        out[3] = yx;
        out[4] = yy;
        out[5] = yz;
        out[6] = zx;
        out[7] = zy;
        out[8] = zz;
    }

    /** x component, in the outer frame, of a vector of the inner frame. */
    public double outX(double x, double y, double z) {
        return xx * x + xy * y + xz * z;
    }

    /** y component, in the outer frame, of a vector of the inner frame. */
    public double outY(double x, double y, double z) {
        return yx * x + yy * y + yz * z;
    }

    /** z component, in the outer frame, of a vector of the inner frame. */
    public double outZ(double x, double y, double z) {
        return zx * x + zy * y + zz * z;
    }

    /** x component, in the inner frame, of a vector of the outer frame. */
    public double inX(double x, double y, double z) {
        return xx * x + yx * y + zx * z;
    }

    /** y component, in the inner frame, of a vector of the outer frame. */
    public double inY(double x, double y, double z) {
        return xy * x + yy * y + zy * z;
    }

    /** z component, in the inner frame, of a vector of the outer frame. */
    public double inZ(double x, double y, double z) {
        return xz * x + yz * y + zz * z;
    }

    /**
     * Writes the rotation matrix of a unit quaternion (x, y, z, w), row by row.
     * @param out takes nine numbers, from {@code at} on
     */
    public static void write(double x, double y, double z, double w, double[] out, int at) {
        out[at] = 1 - 2 * (y * y + z * z);
        out[at + 1] = 2 * (x * y - z * w);
        out[at + 2] = 2 * (x * z + y * w);
        out[at + 3] = 2 * (x * y + z * w);
        out[at + 4] = 1 - 2 * (x * x + z * z);
        out[at + 5] = 2 * (y * z - x * w);
        out[at + 6] = 2 * (x * z - y * w);
        out[at + 7] = 2 * (y * z + x * w);
        out[at + 8] = 1 - 2 * (x * x + y * y);
    }
}
