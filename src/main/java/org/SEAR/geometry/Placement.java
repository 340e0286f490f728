// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/**
 * Mutable pose of a frame in the world: a rotation matrix (world = R * own) and a position in metres. Not thread-safe.
 */
public final class Placement {
    public double m00 = 1;
    public double m01;
    public double m02;
    public double m10;
    public double m11 = 1;
    public double m12;
    public double m20;
    public double m21;
    public double m22 = 1;
    public double x;
    public double y;
    public double z;

    /**
     * Transforms the point (px, py, pz) of the frame to the world.
     * @param into takes {x, y, z}, metres, from {@code at} on
     */
    public void transform(double px, double py, double pz, double[] into, int at) {
        into[at] = x + m00 * px + m01 * py + m02 * pz;
        into[at + 1] = y + m10 * px + m11 * py + m12 * pz;
        into[at + 2] = z + m20 * px + m21 * py + m22 * pz;
    }

    /**
     * Transforms the point (px, py, pz) of the world to the frame.
     * @param into takes {x, y, z}, metres, from {@code at} on
     */
    public void toFrame(double px, double py, double pz, double[] into, int at) {
        double dx = px - x;
        double dy = py - y;
        double dz = pz - z;
        into[at] = m00 * dx + m10 * dy + m20 * dz;
        into[at + 1] = m01 * dx + m11 * dy + m21 * dz;
        into[at + 2] = m02 * dx + m12 * dy + m22 * dz;
    }

    /** Sets the rotation of a unit quaternion. */
    public void setRotation(double qx, double qy, double qz, double qw) {
        m00 = 1 - 2 * (qy * qy + qz * qz);
        m01 = 2 * (qx * qy - qz * qw);
        m02 = 2 * (qx * qz + qy * qw);
        m10 = 2 * (qx * qy + qz * qw);
        m11 = 1 - 2 * (qx * qx + qz * qz);
        m12 = 2 * (qy * qz - qx * qw);
        m20 = 2 * (qx * qz - qy * qw);
        m21 = 2 * (qy * qz + qx * qw);
        m22 = 1 - 2 * (qx * qx + qy * qy);
    }

    /** Becomes the pose in the frame around {@code outer}, the pose of its present parent. */
    public void within(Placement outer) {
        double a0 = m00;
        double a1 = m10;
        double a2 = m20;
        m00 = outer.m00 * a0 + outer.m01 * a1 + outer.m02 * a2;
        m10 = outer.m10 * a0 + outer.m11 * a1 + outer.m12 * a2;
        m20 = outer.m20 * a0 + outer.m21 * a1 + outer.m22 * a2;
        a0 = m01;
        a1 = m11;
        a2 = m21;
        m01 = outer.m00 * a0 + outer.m01 * a1 + outer.m02 * a2;
        m11 = outer.m10 * a0 + outer.m11 * a1 + outer.m12 * a2;
        m21 = outer.m20 * a0 + outer.m21 * a1 + outer.m22 * a2;
        a0 = m02;
        a1 = m12;
        a2 = m22;
        m02 = outer.m00 * a0 + outer.m01 * a1 + outer.m02 * a2;
        m12 = outer.m10 * a0 + outer.m11 * a1 + outer.m12 * a2;
        m22 = outer.m20 * a0 + outer.m21 * a1 + outer.m22 * a2;
        double px = x;
        double py = y;
        double pz = z;
        x = outer.x + outer.m00 * px + outer.m01 * py + outer.m02 * pz;
        y = outer.y + outer.m10 * px + outer.m11 * py + outer.m12 * pz;
        z = outer.z + outer.m20 * px + outer.m21 * py + outer.m22 * pz;
    }
}
