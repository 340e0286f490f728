package org.SEAR.physics;

/**
 * One direction in which two bodies push each other at a point: a row of the constraint matrix, kept in an array of numbers so that a pass over the
 * rows of a pile reads memory from front to back. Velocities are those of {@link SolverBody#v}, of the first body and of the second. Simulation
 * thread.
 */
final class PairRow {
    /** Numbers of a row: the direction, three for each of the moments about both centres of mass and of what 1 Ns turns both by, and two more. */
    static final int SIZE = 17;
    /** Where in a row the impulse of this substep is, Ns. */
    static final int IMPULSE = 16;
    private static final int ARM_A = 3;
    private static final int ARM_B = 6;
    private static final int TURN_A = 9;
    private static final int TURN_B = 12;
    /** Impulse that changes the speed along the row by 1 m/s, kg. */
    static final int MASS = 15;

    private PairRow() {
    }

    /**
     * Makes a row.
     *
     * @param of which bodies, and for how long they turn on
     * @param dx unit direction in which the first body is pushed, likewise dy and dz
     * @param px where, metres, likewise py and pz; all in the world frame
     */
    static void prepare(double[] r, int at, Manifold of, double dx, double dy, double dz, double px, double py, double pz) {
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

    /** What an angular impulse turns a body by; nothing if it does not move. */
    static void turn(double[] r, int by, int into, SolverBody body, boolean moves) {
        double x = moves ? r[by] : 0;
        double y = moves ? r[by + 1] : 0;
        double z = moves ? r[by + 2] : 0;
        r[into] = body.i00 * x + body.i01 * y + body.i02 * z;
        r[into + 1] = body.i01 * x + body.i11 * y + body.i12 * z;
        r[into + 2] = body.i02 * x + body.i12 * y + body.i22 * z;
    }

    /** The product of two vectors in the array. */
    static double dot(double[] r, int one, int other) {
        return r[one] * r[other] + r[one + 1] * r[other + 1] + r[one + 2] * r[other + 2];
    }

    /** How both part here as they move: of their velocities a speed, m/s, of their ways a distance, metres. */
    static double along(double[] r, int at, double[] p, double[] q) {
        return r[at] * (p[0] - q[0]) + r[at + 1] * (p[1] - q[1]) + r[at + 2] * (p[2] - q[2]) + r[at + ARM_A] * p[3] + r[at + ARM_A + 1] * p[4]
            + r[at + ARM_A + 2] * p[5] - r[at + ARM_B] * q[3] - r[at + ARM_B + 1] * q[4] - r[at + ARM_B + 2] * q[5];
    }

    /** Speed at which both part here for an impulse of 1 Ns at another row of theirs with the same direction, 1/kg. */
    static double yields(double[] r, int at, int other, double massA, double massB) {
        return massA + massB + dot(r, at + ARM_A, other + TURN_A) + dot(r, at + ARM_B, other + TURN_B);
    }

    /** The impulse after which both part with a speed, m/s. */
    static double wanted(double[] r, int at, double[] p, double[] q, double speed) {
        return r[at + IMPULSE] + missing(r, at, p, q, speed);
    }

    /** What further impulse makes both part with a speed, m/s. */
    static double missing(double[] r, int at, double[] p, double[] q, double speed) {
        return r[at + MASS] * (speed - along(r, at, p, q));
    }

    /** Changes the velocities of both bodies by an impulse; massA and massB are their inverse masses, 1/kg. */
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
