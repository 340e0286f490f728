// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

/**
 * Row of the constraint matrix for two bodies at a point along one direction. Rows are in an array of numbers, so that
 * a pass over a stack reads memory in order. Velocities are those of {@link SolverBody#v} of the first and the second
 * body. Simulation thread.
 */
final class PairRow {
    /**
     * Numbers per row: direction, both moments, both angular responses to 1 N s (three each), effective mass and
     * impulse.
     */
    static final int SIZE = 17;
    /** Offset of the impulse of this substep, N s. */
    static final int IMPULSE = 16;
    private static final int ARM_A = 3;
    private static final int ARM_B = 6;
    private static final int TURN_A = 9;
    private static final int TURN_B = 12;
    /** Offset of the effective mass, kg. */
    static final int MASS = 15;

    private PairRow() {
    }

    /**
     * Sets up a row.
     * @param of bodies, inverse masses and lead times
     * @param dx unit direction of the impulse on the first body, likewise dy and dz
     * @param px point, metres, likewise py and pz; all in the world frame
     */
    static void prepare(double[] r, int at, Manifold of, double dx, double dy, double dz, double px, double py,
        double pz) {
        r[at] = dx;
        r[at + 1] = dy;
        r[at + 2] = dz;
        of.a.arm(px, py, pz, of.leadA, of.arm);
        moment(r, at, at + ARM_A, of.arm);
        turn(r, at + ARM_A, at + TURN_A, of.a, of.massA > 0);
        of.b.arm(px, py, pz, of.leadB, of.arm);
        moment(r, at, at + ARM_B, of.arm);
        turn(r, at + ARM_B, at + TURN_B, of.b, of.massB > 0);
        double yields = of.massA + of.massB + dot(r, at + ARM_A, at + TURN_A) + dot(r, at + ARM_B, at + TURN_B);
        r[at + MASS] = yields > 0 ? 1 / yields : 0;
    }

    private static void moment(double[] r, int at, int into, double[] arm) {
        r[into] = arm[1] * r[at + 2] - arm[2] * r[at + 1];
        r[into + 1] = arm[2] * r[at] - arm[0] * r[at + 2];
        r[into + 2] = arm[0] * r[at + 1] - arm[1] * r[at];
    }

    /** Computes the angular velocity due to an angular impulse; zero if the body does not move. */
    static void turn(double[] r, int by, int into, SolverBody body, boolean moves) {
        double x = moves ? r[by] : 0;
        double y = moves ? r[by + 1] : 0;
        double z = moves ? r[by + 2] : 0;
        r[into] = body.i00 * x + body.i01 * y + body.i02 * z;
        r[into + 1] = body.i01 * x + body.i11 * y + body.i12 * z;
        r[into + 2] = body.i02 * x + body.i12 * y + body.i22 * z;
    }

    /** Returns the scalar product of two vectors in the array. */
    static double dot(double[] r, int one, int other) {
        return r[one] * r[other] + r[one + 1] * r[other + 1] + r[one + 2] * r[other + 2];
    }

    /**
     * Projects the relative motion of both bodies on the row: separating speed, m/s, from velocities; separation,
     * metres, from displacements.
     */
    static double along(double[] r, int at, double[] p, double[] q) {
        return r[at] * (p[0] - q[0]) + r[at + 1] * (p[1] - q[1]) + r[at + 2] * (p[2] - q[2]) + r[at + ARM_A] * p[3]
            + r[at + ARM_A + 1] * p[4]
            + r[at + ARM_A + 2] * p[5] - r[at + ARM_B] * q[3] - r[at + ARM_B + 1] * q[4] - r[at + ARM_B + 2] * q[5];
    }

    /** Returns the separating speed at this row per impulse of 1 N s at another row with the same direction, 1/kg. */
    static double yields(double[] r, int at, int other, double massA, double massB) {
        return massA + massB + dot(r, at + ARM_A, other + TURN_A) + dot(r, at + ARM_B, other + TURN_B);
    }

    /** Returns the total impulse for a separating speed in m/s, N s. */
    static double wanted(double[] r, int at, double[] p, double[] q, double speed) {
        return r[at + IMPULSE] + missing(r, at, p, q, speed);
    }

    /** Returns the additional impulse for a separating speed in m/s, N s. */
    static double missing(double[] r, int at, double[] p, double[] q, double speed) {
        return r[at + MASS] * (speed - along(r, at, p, q));
    }

    /** Applies an impulse to the velocities of both bodies; massA and massB are their inverse masses, 1/kg. */
    static void applyImpulse(double[] r, int at, double[] p, double[] q, double massA, double massB, double impulse) {
        double pa = impulse * massA;
        double pb = impulse * massB;
        p[0] += r[at] * pa;
        p[1] += r[at + 1] * pa;
        p[2] += r[at + 2] * pa;
        p[3] += r[at + TURN_A] * impulse;
        p[4] += r[at + TURN_A + 1] * impulse;
        p[5] += r[at + TURN_A + 2] * impulse;
        q[0] -= r[at] * pb;
        q[1] -= r[at + 1] * pb;
        q[2] -= r[at + 2] * pb;
        q[3] -= r[at + TURN_B] * impulse;
        q[4] -= r[at + TURN_B + 1] * impulse;
        q[5] -= r[at + TURN_B + 2] * impulse;
    }
}
