// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;


/**
 * Row of the constraint matrix: an impulse on a body at a point along one direction, and its reverse on another movable
 * body, if there is one. Velocities are {vx, vy, vz, wx, wy, wz} of the centre of mass, world frame. Simulation thread.
 */
public final class ConstraintRow {
    private double lx;
    private double ly;
    private double lz;
    private double ax;
    private double ay;
    private double az;
    private double ix;
    private double iy;
    private double iz;
    private double inverseMass;
    private final double[] arm = new double[3];
    private final double[] turn = new double[3];
    /** Velocities of the other body; null if it does not move. */
    private double[] others;
    private double othersInverseMass;
    /** Inverse effective mass: change of speed along the row per unit impulse, 1/kg. */
    public double mobility;
    /** Accumulated impulse of this step, N s. */
    public double impulse;

    /**
     * Sets up the row for a body.
     * @param dx unit direction, likewise dy and dz
     * @param x point of application, metres, likewise y and z; all in the world frame
     * @param other takes the reverse impulse; null if it does not move
     */
    public void set(double dx, double dy, double dz, double x, double y, double z, SolverBody body, SolverBody other) {
        double rx = x - body.place.x;
        double ry = y - body.place.y;
        double rz = z - body.place.z;
        lx = dx;
        ly = dy;
        lz = dz;
        ax = ry * dz - rz * dy;
        ay = rz * dx - rx * dz;
        az = rx * dy - ry * dx;
        ix = body.i00 * ax + body.i01 * ay + body.i02 * az;
        iy = body.i01 * ax + body.i11 * ay + body.i12 * az;
        iz = body.i02 * ax + body.i12 * ay + body.i22 * az;
        inverseMass = body.inverseMass;
        mobility = inverseMass + ax * ix + ay * iy + az * iz;
        others = null;
        if (other != null) {
            join(x - other.place.x, y - other.place.y, z - other.place.z, other);
        }
    }

    private void join(double rx, double ry, double rz, SolverBody other) {
        others = other.v;
        othersInverseMass = other.inverseMass;
        arm[0] = ry * lz - rz * ly;
        arm[1] = rz * lx - rx * lz;
        arm[2] = rx * ly - ry * lx;
        turn[0] = other.i00 * arm[0] + other.i01 * arm[1] + other.i02 * arm[2];
        turn[1] = other.i01 * arm[0] + other.i11 * arm[1] + other.i12 * arm[2];
        turn[2] = other.i02 * arm[0] + other.i12 * arm[1] + other.i22 * arm[2];
        mobility += othersInverseMass + arm[0] * turn[0] + arm[1] * turn[1] + arm[2] * turn[2];
    }

    /** Returns the speed of the point along the direction relative to the other body, m/s. */
    public double speed(double[] v) {
        double speed = lx * v[0] + ly * v[1] + lz * v[2] + ax * v[3] + ay * v[4] + az * v[5];
        return others == null ? speed : speed - lx * others[0] - ly * others[1] - lz * others[2] - arm[0] * others[3]
            - arm[1] * others[4]
            - arm[2] * others[5];
    }

    /** Applies an impulse to the velocities, and its reverse to the other body. */
    public void applyImpulse(double[] v, double newtonSeconds) {
        double linear = newtonSeconds * inverseMass;
        v[0] += lx * linear;
        v[1] += ly * linear;
        v[2] += lz * linear;
        v[3] += ix * newtonSeconds;
        v[4] += iy * newtonSeconds;
        v[5] += iz * newtonSeconds;
        if (others != null) {
            linear = newtonSeconds * othersInverseMass;
            others[0] -= lx * linear;
            others[1] -= ly * linear;
            others[2] -= lz * linear;
            others[3] -= turn[0] * newtonSeconds;
            others[4] -= turn[1] * newtonSeconds;
            others[5] -= turn[2] * newtonSeconds;
        }
    }

    /** Adds to the accumulated impulse, clamps it and applies the difference. */
    public void add(double[] v, double change, double least, double most) {
        double sum = Math.max(least, Math.min(most, impulse + change));
        applyImpulse(v, sum - impulse);
        impulse = sum;
    }
}
