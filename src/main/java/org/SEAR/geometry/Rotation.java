// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/**
 * Mutable rotation matrix between an inner and an outer frame, set at each step without allocation. Not thread-safe.
 */
public final class Rotation {
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
