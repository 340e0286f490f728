package org.SEAR.sensors;

import org.SEAR.raycast.Pose;

/** A rotation between an inner and an outer frame as matrix, to be set again at each step without allocation. */
final class Rotation {
    double xx;
    double xy;
    double xz;
    double yx;
    double yy;
    double yz;
    double zx;
    double zy;
    double zz;

    /** Takes the rotation of a pose. */
    Rotation set(Pose pose) {
        return set(pose.qx, pose.qy, pose.qz, pose.qw);
    }

    /** Takes the rotation of a quaternion of any length but 0. */
    Rotation set(double qx, double qy, double qz, double qw) {
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
    double outX(double x, double y, double z) {
        return xx * x + xy * y + xz * z;
    }

    /** y component, in the outer frame, of a vector of the inner frame. */
    double outY(double x, double y, double z) {
        return yx * x + yy * y + yz * z;
    }

    /** z component, in the outer frame, of a vector of the inner frame. */
    double outZ(double x, double y, double z) {
        return zx * x + zy * y + zz * z;
    }

    /** x component, in the inner frame, of a vector of the outer frame. */
    double inX(double x, double y, double z) {
        return xx * x + yx * y + zx * z;
    }

    /** y component, in the inner frame, of a vector of the outer frame. */
    double inY(double x, double y, double z) {
        return xy * x + yy * y + zy * z;
    }

    /** z component, in the inner frame, of a vector of the outer frame. */
    double inZ(double x, double y, double z) {
        return xz * x + yz * y + zz * z;
    }
}
