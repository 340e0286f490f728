// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.geometry.Placement;

/**
 * Friction of a manifold at the centre of its points: against sliding in any direction with one coefficient (Coulomb's
 * cone), against spinning about the normal, and against rolling. Its numbers are in the array of {@link ContactRows};
 * between steps the manifold keeps the impulses. Simulation thread.
 */
final class FrictionRows {
    private static final int SECOND = PairRow.SIZE;
    private static final int TURNED = 2 * PairRow.SIZE;
    private static final int TURNING_MASS = TURNED + 1;
    /** Change of each body's angular velocity per 1 N m s about the normal. */
    private static final int TURN_A = TURNED + 2;
    private static final int TURN_B = TURNED + 5;
    /** Normal, for spinning. */
    private static final int NORMAL = TURNED + 8;
    /** Rolling resistance: torque per newton, metres. */
    private static final int LEVER = TURNED + 11;
    private static final int ROLLING_MASS = TURNED + 12;
    /** 1 if it rolls about the axis only. */
    private static final int ABOUT_AXIS = TURNED + 13;
    private static final int AXIS = TURNED + 14;
    private static final int ROLL = TURNED + 17;
    static final int SIZE = TURNED + 20;
    /**
     * Rolling resistance of edges and corners, metres: without it a box that leans on others by corners would rock for
     * ever. A tenth of the value of a hard wheel on a hard floor.
     */
    private static final double ROCKING = 2e-5;
    /** With fewer points than this a body can rock. */
    private static final int STANDS = 3;

    private FrictionRows() {
    }

    /**
     * Sets up the rows at the centre of the manifold's points: {mx, my, mz}, metres, world frame.
     */
    static void prepare(double[] r, int at, Manifold of, double mx, double my, double mz) {
        r[at + NORMAL] = of.nx;
        r[at + NORMAL + 1] = of.ny;
        r[at + NORMAL + 2] = of.nz;
        tangents(r, at, of, mx, my, mz);
        r[at + PairRow.IMPULSE] = of.fx * r[at] + of.fy * r[at + 1] + of.fz * r[at + 2];
        r[at + SECOND + PairRow.IMPULSE] = of.fx * r[at + SECOND] + of.fy * r[at + SECOND + 1]
            + of.fz * r[at + SECOND + 2];
        r[at + TURNED] = of.turned;
        PairRow.turn(r, at + NORMAL, at + TURN_A, of.a, of.massA > 0);
        PairRow.turn(r, at + NORMAL, at + TURN_B, of.b, of.massB > 0);
        double yields = PairRow.dot(r, at + NORMAL, at + TURN_A) + PairRow.dot(r, at + NORMAL, at + TURN_B);
        r[at + TURNING_MASS] = yields > 0 ? 1 / yields : 0;
        r[at + ROLL] = of.rollX;
        r[at + ROLL + 1] = of.rollY;
        r[at + ROLL + 2] = of.rollZ;
        r[at + LEVER] = 0;
        if (of.rolling > 0) {
            prepareRolling(r, at, of, mx, my, mz);
        } else if (of.rocks && of.count < STANDS) {
            r[at + LEVER] = ROCKING;
            aboutAll(r, at, of);
        }
    }

    /** Sets up two tangents at right angles; the same normal always gives the same tangents. */
    private static void tangents(double[] r, int at, Manifold of, double mx, double my, double mz) {
        boolean acrossX = Math.abs(of.nx) < 0.6;
        double length = Math.sqrt(of.ny * of.ny + (acrossX ? of.nz * of.nz : of.nx * of.nx));
        double x = acrossX ? 0 : of.ny / length;
        double y = (acrossX ? of.nz : -of.nx) / length;
        double z = acrossX ? -of.ny / length : 0;
        PairRow.prepare(r, at, of, x, y, z, mx, my, mz);
        PairRow.prepare(r, at + SECOND, of, of.ny * z - of.nz * y, of.nz * x - of.nx * z, of.nx * y - of.ny * x,
            mx, my, mz);
    }

    /**
     * Sets up rolling resistance: force times coefficient times distance of the rolling body's centre from the surface.
     * A body that is round about one axis rolls about it only: tipping over its rim is not rolling.
     */
    private static void prepareRolling(double[] r, int at, Manifold of, double x, double y, double z) {
        double fromA = of.bodyA.canRoll() ? distance(of, of.a, x, y, z) : 0;
        double fromB = of.bodyB.canRoll() ? distance(of, of.b, x, y, z) : 0;
        r[at + LEVER] = of.rolling * Math.max(fromA, fromB);
        Body roller = fromA >= fromB ? of.bodyA : of.bodyB;
        if (roller.isRoundAboutAxis()) {
            r[at + ABOUT_AXIS] = 1;
            Placement place = roller.getSolver().place;
            r[at + AXIS] = place.m01;
            r[at + AXIS + 1] = place.m11;
            r[at + AXIS + 2] = place.m21;
            setMass(r, at, (of.massA > 0 ? turns(of.a, r, at + AXIS) : 0)
                + (of.massB > 0 ? turns(of.b, r, at + AXIS) : 0));
            double along = PairRow.dot(r, at + ROLL, at + AXIS);
            for (int i = 0; i < 3; i++) {
                r[at + ROLL + i] = along * r[at + AXIS + i];
            }
        } else {
            aboutAll(r, at, of);
        }
    }

    private static void aboutAll(double[] r, int at, Manifold of) {
        double softest = 0;
        for (int i = 0; i < 3; i++) {
            softest = Math.max(softest, (of.massA > 0 ? diagonal(of.a, i) : 0)
                + (of.massB > 0 ? diagonal(of.b, i) : 0));
        }
        r[at + ABOUT_AXIS] = 0;
        setMass(r, at, softest);
    }

    private static void setMass(double[] r, int at, double yields) {
        r[at + ROLLING_MASS] = yields > 0 ? 1 / yields : 0;
    }

    private static double distance(Manifold of, SolverBody body, double x, double y, double z) {
        return Math.abs((body.place.x - x) * of.nx + (body.place.y - y) * of.ny + (body.place.z - z) * of.nz);
    }

    private static double turns(SolverBody body, double[] r, int axis) {
        double x = r[axis];
        double y = r[axis + 1];
        double z = r[axis + 2];
        return x * (body.i00 * x + body.i01 * y + body.i02 * z) + y * (body.i01 * x + body.i11 * y + body.i12 * z)
            + z * (body.i02 * x + body.i12 * y + body.i22 * z);
    }

    private static double diagonal(SolverBody body, int axis) {
        return axis == 0 ? body.i00 : axis == 1 ? body.i11 : body.i22;
    }

    /** Copies the impulses to the manifold, as vectors, because the tangents may differ in the next step. */
    static void store(double[] r, int at, Manifold into) {
        double first = r[at + PairRow.IMPULSE];
        double second = r[at + SECOND + PairRow.IMPULSE];
        into.fx = r[at] * first + r[at + SECOND] * second;
        into.fy = r[at + 1] * first + r[at + SECOND + 1] * second;
        into.fz = r[at + 2] * first + r[at + SECOND + 2] * second;
        into.turned = r[at + TURNED];
        into.rollX = r[at + ROLL];
        into.rollY = r[at + ROLL + 1];
        into.rollZ = r[at + ROLL + 2];
    }

    /** Passes the impulses of a contact on to another one with a similar normal. */
    static void passOn(double[] r, int from, int to) {
        for (int row = from; row <= from + SECOND; row += SECOND) {
            double impulse = r[row + PairRow.IMPULSE];
            r[to + PairRow.IMPULSE] += impulse * PairRow.dot(r, row, to);
            r[to + SECOND + PairRow.IMPULSE] += impulse * PairRow.dot(r, row, to + SECOND);
            r[row + PairRow.IMPULSE] = 0;
        }
        r[to + TURNED] += r[from + TURNED];
        r[from + TURNED] = 0;
        for (int i = 0; i < 3; i++) {
            r[to + ROLL + i] += r[from + ROLL + i];
            r[from + ROLL + i] = 0;
        }
    }

    /** Whether any friction impulse is stored. */
    static boolean holds(double[] r, int at) {
        return r[at + PairRow.IMPULSE] != 0 || r[at + SECOND + PairRow.IMPULSE] != 0 || r[at + TURNED] != 0
            || rolls(r, at);
    }

    /** Returns where an impulse is: 0 and 1 against sliding, 2 against turning about the normal. */
    static int impulseAt(int at, int i) {
        return i == 0 ? at + PairRow.IMPULSE : i == 1 ? at + SECOND + PairRow.IMPULSE : at + TURNED;
    }

    private static boolean rolls(double[] r, int at) {
        return r[at + ROLL] != 0 || r[at + ROLL + 1] != 0 || r[at + ROLL + 2] != 0;
    }

    /** @param scale length of this substep over that of the last */
    static void warmStart(double[] r, int at, ContactRows rows, int slot, double scale) {
        r[at + PairRow.IMPULSE] *= scale;
        r[at + SECOND + PairRow.IMPULSE] *= scale;
        r[at + TURNED] *= scale;
        rows.applyImpulse(slot, at, r[at + PairRow.IMPULSE]);
        rows.applyImpulse(slot, at + SECOND, r[at + SECOND + PairRow.IMPULSE]);
        twist(r, at, rows, slot, r[at + TURNED]);
        if (r[at + LEVER] > 0) {
            for (int i = 0; i < 3; i++) {
                r[at + ROLL + i] *= scale;
            }
            if (rolls(r, at)) {
                rows.twist(slot, r[at + ROLL], r[at + ROLL + 1], r[at + ROLL + 2]);
            }
        }
    }

    /** Changes the impulse against turning about the normal, N m s, of both bodies. */
    static void twist(double[] r, int at, ContactRows rows, int slot, double change) {
        double[] p = rows.speedsA(slot);
        double[] q = rows.speedsB(slot);
        p[3] += r[at + TURN_A] * change;
        p[4] += r[at + TURN_A + 1] * change;
        p[5] += r[at + TURN_A + 2] * change;
        q[3] -= r[at + TURN_B] * change;
        q[4] -= r[at + TURN_B + 1] * change;
        q[5] -= r[at + TURN_B + 2] * change;
    }

    /**
     * Solves one pass.
     * @param most largest impulse against sliding, N s
     * @param mostTurning largest angular impulse about the normal, N m s
     * @param pressing total normal impulse, N s
     */
    static void solve(double[] r, int at, ContactRows rows, int slot, double most, double mostTurning,
        double pressing) {
        double[] p = rows.speedsA(slot);
        double[] q = rows.speedsB(slot);
        if (r[at + LEVER] > 0 && (pressing > 0 || rolls(r, at))) {
            solveRolling(r, at, rows, slot, pressing * r[at + LEVER]);
        }
        if (mostTurning > 0 || r[at + TURNED] != 0) {
            double turning = r[at + NORMAL] * (p[3] - q[3]) + r[at + NORMAL + 1] * (p[4] - q[4])
                + r[at + NORMAL + 2] * (p[5] - q[5]);
            double sum = Math.max(-mostTurning, Math.min(mostTurning, r[at + TURNED] - r[at + TURNING_MASS] * turning));
            twist(r, at, rows, slot, sum - r[at + TURNED]);
            r[at + TURNED] = sum;
        }
        double one = PairRow.wanted(r, at, p, q, 0);
        double other = PairRow.wanted(r, at + SECOND, p, q, 0);
        double length = Math.sqrt(one * one + other * other);
        double scale = length > most ? most / length : 1;
        rows.note((one * scale - r[at + PairRow.IMPULSE]) / r[at + PairRow.MASS]);
        rows.note((other * scale - r[at + SECOND + PairRow.IMPULSE]) / r[at + SECOND + PairRow.MASS]);
        rows.applyImpulse(slot, at, one * scale - r[at + PairRow.IMPULSE]);
        rows.applyImpulse(slot, at + SECOND, other * scale - r[at + SECOND + PairRow.IMPULSE]);
        r[at + PairRow.IMPULSE] = one * scale;
        r[at + SECOND + PairRow.IMPULSE] = other * scale;
    }

    private static void solveRolling(double[] r, int at, ContactRows rows, int slot, double most) {
        double[] p = rows.speedsA(slot);
        double[] q = rows.speedsB(slot);
        double wx = p[3] - q[3];
        double wy = p[4] - q[4];
        double wz = p[5] - q[5];
        if (r[at + ABOUT_AXIS] > 0) {
            double along = wx * r[at + AXIS] + wy * r[at + AXIS + 1] + wz * r[at + AXIS + 2];
            wx = along * r[at + AXIS];
            wy = along * r[at + AXIS + 1];
            wz = along * r[at + AXIS + 2];
        }
        double x = r[at + ROLL] - r[at + ROLLING_MASS] * wx;
        double y = r[at + ROLL + 1] - r[at + ROLLING_MASS] * wy;
        double z = r[at + ROLL + 2] - r[at + ROLLING_MASS] * wz;
        double length = Math.sqrt(x * x + y * y + z * z);
        double scale = length > most ? most / length : 1;
        rows.twist(slot, x * scale - r[at + ROLL], y * scale - r[at + ROLL + 1], z * scale - r[at + ROLL + 2]);
        r[at + ROLL] = x * scale;
        r[at + ROLL + 1] = y * scale;
        r[at + ROLL + 2] = z * scale;
    }
}
