// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/** Mutable vector, so that a step allocates none. Not thread-safe. */
public final class Vec3 {
    public double x;
    public double y;
    public double z;

    public Vec3 set(double newX, double newY, double newZ) {
        x = newX;
        y = newY;
        z = newZ;
        return this;
    }

    public Vec3 set(Vec3 other) {
        return set(other.x, other.y, other.z);
    }

    /** @param other {x, y, z} */
    public Vec3 set(double[] other) {
        return set(other[0], other[1], other[2]);
    }

    /** Becomes the cross product a x b; either may be this one. */
    public Vec3 cross(Vec3 a, Vec3 b) {
        return set(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    }

    /** Becomes this + factor * other. */
    public Vec3 add(double factor, Vec3 other) {
        return set(x + factor * other.x, y + factor * other.y, z + factor * other.z);
    }

    public Vec3 scale(double factor) {
        return set(factor * x, factor * y, factor * z);
    }

    public double dot(Vec3 other) {
        return x * other.x + y * other.y + z * other.z;
    }

    public double length() {
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** Becomes a unit vector; its length must not be 0. */
    public Vec3 normalize() {
        return scale(1 / length());
    }

    /** Removes the component along a unit vector. */
    public Vec3 flatten(Vec3 unit) {
        return add(-dot(unit), unit);
    }

    /** Becomes the point (px, py, pz) of a pose's frame, in the parent frame. */
    public Vec3 transform(Pose pose, double px, double py, double pz) {
        rotate(pose, px, py, pz);
        return set(x + pose.x, y + pose.y, z + pose.z);
    }

    /** Becomes the direction (vx, vy, vz) of a pose's frame, in the parent frame. */
    public Vec3 rotate(Pose pose, double vx, double vy, double vz) {
        double tx = 2 * (pose.qy * vz - pose.qz * vy);
        double ty = 2 * (pose.qz * vx - pose.qx * vz);
        double tz = 2 * (pose.qx * vy - pose.qy * vx);
        return set(vx + pose.qw * tx + pose.qy * tz - pose.qz * ty, vy + pose.qw * ty + pose.qz * tx - pose.qx * tz,
            vz + pose.qw * tz + pose.qx * ty - pose.qy * tx);
    }

    @Override
    public String toString() {
        return "(" + x + ", " + y + ", " + z + ")";
    }
}
