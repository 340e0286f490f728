// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/** Mutable pose: the same arithmetic as {@link Pose#times}, without allocation. Simulation thread. */
public final class Frame {
    public double x;
    public double y;
    public double z;
    public double qx;
    public double qy;
    public double qz;
    public double qw = 1;

    public void set(Pose pose) {
        x = pose.x;
        y = pose.y;
        z = pose.z;
        qx = pose.qx;
        qy = pose.qy;
        qz = pose.qz;
        qw = pose.qw;
    }

    /** Becomes the pose in the parent frame of a pose in this frame. */
    public void times(Pose inner) {
        times(inner.x, inner.y, inner.z, inner.qx, inner.qy, inner.qz, inner.qw);
    }

    /** Becomes the pose in the parent frame of (ix, iy, iz; jx, jy, jz, jw) in this frame. */
    public void times(double ix, double iy, double iz, double jx, double jy, double jz, double jw) {
        double tx = 2 * (qy * iz - qz * iy);
        double ty = 2 * (qz * ix - qx * iz);
        double tz = 2 * (qx * iy - qy * ix);
        x = ix + qw * tx + qy * tz - qz * ty + x;
        y = iy + qw * ty + qz * tx - qx * tz + y;
        z = iz + qw * tz + qx * ty - qy * tx + z;
        double ux = qx;
        double uy = qy;
        double uz = qz;
        double uw = qw;
        qx = uw * jx + ux * jw + uy * jz - uz * jy;
        qy = uw * jy - ux * jz + uy * jw + uz * jx;
        qz = uw * jz + ux * jy - uy * jx + uz * jw;
        qw = uw * jw - ux * jx - uy * jy - uz * jz;
    }
}
