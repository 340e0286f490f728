// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.PrincipalAxes;

/**
 * Orientation and torque-free rotation of a rigid body by Euler's equations: the angular momentum is constant, the axis
 * of rotation precesses. Integrates the quaternion of the principal axes of inertia, which may be turned against the
 * body's own axes, by the fourth-order Runge-Kutta method. Simulation thread.
 */
final class AngularState {
    /** Largest rotation of one integration step, radians. */
    private static final double PIECE = 0.15;
    /** Largest number of integration steps in a substep; faster rotation is inaccurate. */
    private static final int MAX_PIECES = 64;
    /**
     * Rotation below which a series gives the change of the angular velocity, radians; its relative error is a
     * millionth.
     */
    private static final double LITTLE = 0.01;
    /** Relative difference of the moments of inertia below which the body rotates evenly about any axis. */
    private static final double EVEN = 1e-9;

    /** Orientation of the principal axes of inertia in the world. */
    private double qx;
    private double qy;
    private double qz;
    private double qw = 1;
    /** Principal axes in the body's frame. */
    private Pose own = Pose.IDENTITY;
    private final Placement principal = new Placement();
    private double jx;
    private double jy;
    private double jz;
    private double inverseX;
    private double inverseY;
    private double inverseZ;
    private boolean even = true;
    private final double[] momentum = new double[3];
    private final double[] rate = new double[4];
    private final double[] sum = new double[4];

    /** @param axes principal axes in the body's frame; a body without moments does not rotate. Before {@link #set}. */
    void setInertia(PrincipalAxes axes) {
        own = axes.frame;
        jx = axes.x;
        jy = axes.y;
        jz = axes.z;
        inverseX = jx > 0 ? 1 / jx : 0;
        inverseY = jy > 0 ? 1 / jy : 0;
        inverseZ = jz > 0 ? 1 / jz : 0;
        even = Math.abs(jx - jy) <= EVEN * jx && Math.abs(jx - jz) <= EVEN * jx;
    }

    /** Sets the body's orientation in the world, a quaternion. */
    void set(double x, double y, double z, double w) {
        qx = x * own.qw + w * own.qx + y * own.qz - z * own.qy;
        qy = y * own.qw + w * own.qy + z * own.qx - x * own.qz;
        qz = z * own.qw + w * own.qz + x * own.qy - y * own.qx;
        qw = w * own.qw - x * own.qx - y * own.qy - z * own.qz;
        normalize();
    }

    /** The body's orientation in the world, likewise {@link #qy}, {@link #qz} and {@link #qw}. */
    double qx() {
        return qx * own.qw - qw * own.qx - qy * own.qz + qz * own.qy;
    }

    double qy() {
        return qy * own.qw - qw * own.qy - qz * own.qx + qx * own.qz;
    }

    double qz() {
        return qz * own.qw - qw * own.qz - qx * own.qy + qy * own.qx;
    }

    double qw() {
        return qw * own.qw + qx * own.qx + qy * own.qy + qz * own.qz;
    }

    /** Inverse principal moment of inertia, 1/(kg m^2), likewise about y and z. */
    double inverseX() {
        return inverseX;
    }

    double inverseY() {
        return inverseY;
    }

    double inverseZ() {
        return inverseZ;
    }

    /** Sets the rotation matrix of the body. */
    void matrix(Placement into) {
        into.setRotation(qx(), qy(), qz(), qw());
    }

    /**
     * Returns the rotation matrix of the principal axes. Not a copy.
     * @param body the one that {@link #matrix} has set
     */
    Placement principal(Placement body) {
        if (own == Pose.IDENTITY) {
            return body;
        }
        principal.setRotation(qx, qy, qz, qw);
        return principal;
    }

    /**
     * Integrates the rotation without torque.
     * @param v angular velocity in the world from index 3 on, rad/s; changed to the one at the end
     */
    void turn(double[] v, double seconds) {
        double speed = Math.sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5]);
        if (even) {
            turnEvenly(v, speed, seconds);
            return;
        }
        toPrincipal(v[3], v[4], v[5], momentum);
        toWorld(momentum[0] * jx, momentum[1] * jy, momentum[2] * jz, momentum);
        double lx = momentum[0];
        double ly = momentum[1];
        double lz = momentum[2];
        int pieces = (int) Math.max(1, Math.min(MAX_PIECES, Math.ceil(speed * seconds / PIECE)));
        for (int i = 0; i < pieces; i++) {
            piece(lx, ly, lz, seconds / pieces);
        }
        toPrincipal(lx, ly, lz, momentum);
        toWorld(momentum[0] * inverseX, momentum[1] * inverseY, momentum[2] * inverseZ, momentum);
        v[3] = momentum[0];
        v[4] = momentum[1];
        v[5] = momentum[2];
    }

    /**
     * Integrates the gyroscopic change of the angular velocity; the orientation stays.
     * @param v angular velocity in the world from index 3 on, rad/s; changed to the one at the end
     */
    void gyrate(double[] v, double seconds) {
        if (even) {
            return;
        }
        double square = v[3] * v[3] + v[4] * v[4] + v[5] * v[5];
        if (square * seconds * seconds < LITTLE * LITTLE) {
            gyrateLittle(v, seconds);
            return;
        }
        double x = qx;
        double y = qy;
        double z = qz;
        double w = qw;
        turn(v, seconds);
        qx = x;
        qy = y;
        qz = z;
        qw = w;
    }

    /**
     * Solves Euler's equations in the principal axes by the midpoint rule and rotates the result with these axes, up to
     * the second order.
     */
    private void gyrateLittle(double[] v, double seconds) {
        rotate(-qx, -qy, -qz, 2, v[3], v[4], v[5], momentum);
        double x = momentum[0];
        double y = momentum[1];
        double z = momentum[2];
        double half = seconds / 2;
        double midX = x + half * inverseX * (jy - jz) * y * z;
        double midY = y + half * inverseY * (jz - jx) * z * x;
        double midZ = z + half * inverseZ * (jx - jy) * x * y;
        x += seconds * inverseX * (jy - jz) * midY * midZ;
        y += seconds * inverseY * (jz - jx) * midZ * midX;
        z += seconds * inverseZ * (jx - jy) * midX * midY;
        double crossX = seconds * (midY * z - midZ * y);
        double crossY = seconds * (midZ * x - midX * z);
        double crossZ = seconds * (midX * y - midY * x);
        rotate(qx, qy, qz, 2, x + crossX + half * (midY * crossZ - midZ * crossY), y + crossY
            + half * (midZ * crossX - midX * crossZ),
            z + crossZ + half * (midX * crossY - midY * crossX), momentum);
        v[3] = momentum[0];
        v[4] = momentum[1];
        v[5] = momentum[2];
    }

    /** Integrates the rotation with constant angular velocity, for bodies under constraints. */
    void turnHeld(double[] v, double seconds) {
        turnEvenly(v, Math.sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5]), seconds);
    }

    /**
     * The product of unit quaternions differs from length 1 by rounding only; the first term of the root's series
     * corrects it.
     */
    private void turnEvenly(double[] v, double speed, double seconds) {
        double half = speed * seconds / 2;
        double sine = half < 1e-4 ? seconds / 2 * (1 - half * half / 6) : Math.sin(half) / speed;
        double x = sine * v[3];
        double y = sine * v[4];
        double z = sine * v[5];
        double w = Math.cos(half);
        double ox = qx;
        double oy = qy;
        double oz = qz;
        double ow = qw;
        qx = w * ox + x * ow + y * oz - z * oy;
        qy = w * oy - x * oz + y * ow + z * ox;
        qz = w * oz + x * oy - y * ox + z * ow;
        qw = w * ow - x * ox - y * oy - z * oz;
        scale(1.5 - (qx * qx + qy * qy + qz * qz + qw * qw) / 2);
    }

    private void piece(double lx, double ly, double lz, double seconds) {
        double x = qx;
        double y = qy;
        double z = qz;
        double w = qw;
        for (int i = 0; i < 4; i++) {
            sum[i] = 0;
        }
        for (int stage = 0; stage < 4; stage++) {
            rate(lx, ly, lz);
            double weight = stage == 0 || stage == 3 ? seconds / 6 : seconds / 3;
            double ahead = stage == 2 ? seconds : seconds / 2;
            for (int i = 0; i < 4; i++) {
                sum[i] += weight * rate[i];
            }
            qx = x + ahead * rate[0];
            qy = y + ahead * rate[1];
            qz = z + ahead * rate[2];
            qw = w + ahead * rate[3];
        }
        qx = x + sum[0];
        qy = y + sum[1];
        qz = z + sum[2];
        qw = w + sum[3];
        normalize();
    }

    /** Computes the time derivative of the quaternion, 1/s, from an angular momentum in the world, N m s. */
    private void rate(double lx, double ly, double lz) {
        toPrincipal(lx, ly, lz, momentum);
        double x = momentum[0] * inverseX / 2;
        double y = momentum[1] * inverseY / 2;
        double z = momentum[2] * inverseZ / 2;
        rate[0] = qw * x + qy * z - qz * y;
        rate[1] = qw * y - qx * z + qz * x;
        rate[2] = qw * z + qx * y - qy * x;
        rate[3] = -qx * x - qy * y - qz * z;
    }

    private void toPrincipal(double x, double y, double z, double[] into) {
        rotate(-qx, -qy, -qz, twice(), x, y, z, into);
    }

    private void toWorld(double x, double y, double z, double[] into) {
        rotate(qx, qy, qz, twice(), x, y, z, into);
    }

    /** Returns 2 over the squared length of the quaternion, which is not 1 within an integration step. */
    private double twice() {
        return 2 / (qx * qx + qy * qy + qz * qz + qw * qw);
    }

    private void rotate(double ax, double ay, double az, double twice, double x, double y, double z, double[] into) {
        double tx = twice * (ay * z - az * y);
        double ty = twice * (az * x - ax * z);
        double tz = twice * (ax * y - ay * x);
        into[0] = x + qw * tx + ay * tz - az * ty;
        into[1] = y + qw * ty + az * tx - ax * tz;
        into[2] = z + qw * tz + ax * ty - ay * tx;
    }

    private void normalize() {
        scale(1 / Math.sqrt(qx * qx + qy * qy + qz * qz + qw * qw));
    }

    private void scale(double scale) {
        qx *= scale;
        qy *= scale;
        qz *= scale;
        qw *= scale;
    }
}
