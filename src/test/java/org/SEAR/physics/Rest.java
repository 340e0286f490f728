// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.geometry.Pose;

/** Decides by poses alone whether a body rests, independently of the sleep state of the physics. */
final class Rest {
    /** Cosine of one degree. */
    static final double FLAT = 0.99985;
    /** Observation time, seconds. */
    static final double WATCH = 0.5;
    /** Movement below which a body rests, metres. */
    private static final double MOVED = 1e-4;
    /** Rotation below which a body rests, radians. */
    private static final double TURNED = 2e-3;

    private Rest() {
    }

    static boolean hasMoved(Pose from, Pose to) {
        return distance(from, to) > MOVED || angle(from, to) > TURNED;
    }

    /** Returns the distance of two poses, metres. */
    static double distance(Pose from, Pose to) {
        double dx = to.x - from.x;
        double dy = to.y - from.y;
        double dz = to.z - from.z;
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /** Returns the angle between two poses, radians. */
    static double angle(Pose from, Pose to) {
        double x = from.qw * to.qx - from.qx * to.qw - from.qy * to.qz + from.qz * to.qy;
        double y = from.qw * to.qy - from.qy * to.qw - from.qz * to.qx + from.qx * to.qz;
        double z = from.qw * to.qz - from.qz * to.qw - from.qx * to.qy + from.qy * to.qx;
        return 2 * Math.asin(Math.min(1, Math.sqrt(x * x + y * y + z * z)));
    }

    /** Returns the speed of {vx, vy, vz, ...}, m/s. */
    static double speed(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
}
