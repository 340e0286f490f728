// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/**
 * Pose of a frame in another: a translation in metres and a rotation as unit quaternion (jME's order x, y, z, w).
 * Immutable, any thread.
 */
public final class Pose {
    /** Cosine of the angle about z below which x and y turn about the same axis. */
    private static final double POLE = 1e-9;
    /** No translation, no rotation. */
    public static final Pose IDENTITY = new Pose(0, 0, 0, 0, 0, 0, 1);

    public final double x;
    public final double y;
    public final double z;
    public final double qx;
    public final double qy;
    public final double qz;
    public final double qw;

    /** @param x metres; the quaternion (qx, qy, qz, qw) must have unit length */
    public Pose(double x, double y, double z, double qx, double qy, double qz, double qw) {
        this.x = x;
        this.y = y;
        this.z = z;
        this.qx = qx;
        this.qy = qy;
        this.qz = qz;
        this.qw = qw;
    }

    /**
     * Returns the pose of move(x, y, z) and rotate(rx, ry, rz), with the rotation of jME's
     * {@code Quaternion.fromAngles} in double precision: matrix Ry Rz Rx, which turns the object about the parent's
     * axes, first x, then z, then y (docs/conventions.md).
     * @param rx degrees about x, likewise ry, rz
     */
    public static Pose ofDegrees(double x, double y, double z, double rx, double ry, double rz) {
        double ax = Math.toRadians(rx) / 2;
        double ay = Math.toRadians(ry) / 2;
        double az = Math.toRadians(rz) / 2;
        double sinX = Math.sin(ax);
        double cosX = Math.cos(ax);
        double sinY = Math.sin(ay);
        double cosY = Math.cos(ay);
        double sinZ = Math.sin(az);
        double cosZ = Math.cos(az);
        double yz = cosY * cosZ;
        double syz = sinY * sinZ;
        double cysz = cosY * sinZ;
        double sycz = sinY * cosZ;
        return new Pose(x, y, z, yz * sinX + syz * cosX, sycz * cosX + cysz * sinX, cysz * cosX - sycz * sinX,
            yz * cosX - syz * sinX);
    }

    /** Returns the angles of {@link #ofDegrees}: degrees about x, y and z. */
    public double[] degrees() {
        double[] x = rotate(1, 0, 0);
        double[] y = rotate(0, 1, 0);
        double[] z = rotate(0, 0, 1);
        boolean pole = Math.hypot(y[1], z[1]) < POLE;
        double about = pole ? 0 : Math.atan2(-z[1], y[1]);
        double turn = pole ? Math.atan2(z[0], z[2]) : Math.atan2(-x[2], x[0]);
        return new double[] {Math.toDegrees(about), Math.toDegrees(turn),
            Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, x[1]))))};
    }

    /** Returns the pose in the parent frame of a pose {@code inner} in this frame. */
    public Pose times(Pose inner) {
        double[] p = transform(inner.x, inner.y, inner.z);
        return new Pose(p[0], p[1], p[2],
            qw * inner.qx + qx * inner.qw + qy * inner.qz - qz * inner.qy,
            qw * inner.qy - qx * inner.qz + qy * inner.qw + qz * inner.qx,
            qw * inner.qz + qx * inner.qy - qy * inner.qx + qz * inner.qw,
            qw * inner.qw - qx * inner.qx - qy * inner.qy - qz * inner.qz);
    }

    /** Transforms the point (px, py, pz) of this frame to the parent frame: {x, y, z}, metres. */
    public double[] transform(double px, double py, double pz) {
        double[] v = rotate(px, py, pz);
        v[0] += x;
        v[1] += y;
        v[2] += z;
        return v;
    }

    /** Rotates the direction (vx, vy, vz) of this frame to the parent frame. */
    public double[] rotate(double vx, double vy, double vz) {
        return rotateBy(vx, vy, vz, qx, qy, qz);
    }

    /** Rotates the direction (vx, vy, vz) of the parent frame to this frame. */
    public double[] rotateBack(double vx, double vy, double vz) {
        return rotateBy(vx, vy, vz, -qx, -qy, -qz);
    }

    private double[] rotateBy(double vx, double vy, double vz, double ux, double uy, double uz) {
        double tx = 2 * (uy * vz - uz * vy);
        double ty = 2 * (uz * vx - ux * vz);
        double tz = 2 * (ux * vy - uy * vx);
        return new double[] {vx + qw * tx + uy * tz - uz * ty, vy + qw * ty + uz * tx - ux * tz, vz + qw * tz
            + ux * ty - uy * tx};
    }

    @Override
    public String toString() {
        return "(" + x + ", " + y + ", " + z + "; " + qx + ", " + qy + ", " + qz + ", " + qw + ")";
    }

    /** Heading of the forward axis z: degrees clockwise from north (+x), (-180, 180]. */
    public double heading() {
        double[] forward = rotate(0, 0, 1);
        return Math.toDegrees(Math.atan2(forward[2], forward[0]));
    }
}
