// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

import java.util.Arrays;
import java.util.List;

/**
 * Constraint rows of a mechanism in a substep. A row asks for {@code speed + softness impulse = target}, where the
 * speed is that of the second body against the first along a direction, within the limits of its impulse. Simulation
 * thread.
 */
final class JointRows {
    /** Largest number of bodies per row: those of two joints with a gear. */
    private static final int TERMS = 4;
    private static final int NUMBERS = 6;

    /** State of a row. */
    enum State {
        /** Without effect in this substep. */
        OFF,
        /** The impulse is that of the equation. */
        FREE,
        /** The impulse is at its lower or upper limit. */
        LOW, HIGH
    }

    final int size;
    final State[] states;
    /** Required speed, m/s or rad/s. */
    final double[] target;
    /** Speed per impulse by which a row yields, 1/kg or 1/(kg m^2). */
    final double[] softness;
    /** Limits of the impulse, and the impulse of this substep, N s or N m s. */
    final double[] low;
    final double[] high;
    final double[] impulse;
    /** Position error, metres or radians; it is 0 where a row has no position. */
    final double[] error;
    /** Whether the position of the row is kept: that of a limit only against one side. */
    final boolean[] kept;
    /** Whether a row only measures a speed. */
    private final boolean[] measuring;
    private final int[] terms;
    private final JointedBody[] bodies;
    private final double[] jacobian;
    /** Velocity change of each body per unit impulse. */
    private final double[] response;

    JointRows(int size) {
        this.size = size;
        states = new State[size];
        target = new double[size];
        softness = new double[size];
        low = new double[size];
        high = new double[size];
        impulse = new double[size];
        error = new double[size];
        kept = new boolean[size];
        measuring = new boolean[size];
        terms = new int[size];
        bodies = new JointedBody[size * TERMS];
        jacobian = new double[size * TERMS * NUMBERS];
        response = new double[size * TERMS * NUMBERS];
    }

    /** Begins a row that holds exactly. */
    void begin(int row) {
        terms[row] = 0;
        states[row] = State.FREE;
        target[row] = 0;
        softness[row] = 0;
        low[row] = Double.NEGATIVE_INFINITY;
        high[row] = Double.POSITIVE_INFINITY;
        impulse[row] = 0;
        error[row] = 0;
        kept[row] = true;
    }

    /** Begins a row that only measures its speed. */
    void beginMeasuring(int row) {
        begin(row);
        measuring[row] = true;
        states[row] = State.OFF;
    }

    /** Limits the impulse of a row. A row that was at a limit in the last substep starts there. */
    void bound(int row, State before, double least, double most) {
        low[row] = least;
        high[row] = most;
        kept[row] = false;
        boolean stays = before == State.LOW ? least > Double.NEGATIVE_INFINITY
            : before == State.HIGH && most < Double.POSITIVE_INFINITY;
        states[row] = stays ? before : State.FREE;
        if (states[row] != State.FREE) {
            push(row, before == State.LOW ? least : most);
        }
    }

    /**
     * Sets up a row for the motion of points along a unit direction.
     * @param n direction, world frame
     * @param p point of application on both bodies, world frame, metres
     */
    void linear(int row, double scale, double[] n, double[] p, JointedBody a, JointedBody b) {
        add(row, a, -scale, n, p);
        add(row, b, scale, n, p);
    }

    private void add(int row, JointedBody body, double scale, double[] n, double[] p) {
        double rx = p[0] - body.place.x;
        double ry = p[1] - body.place.y;
        double rz = p[2] - body.place.z;
        add(row, body, scale * n[0], scale * n[1], scale * n[2], scale * (ry * n[2] - rz * n[1]),
            scale * (rz * n[0] - rx * n[2]),
            scale * (rx * n[1] - ry * n[0]));
    }

    /** Sets up a row for the rotation about a unit direction. */
    void angular(int row, double scale, double[] n, JointedBody a, JointedBody b) {
        add(row, a, 0, 0, 0, -scale * n[0], -scale * n[1], -scale * n[2]);
        add(row, b, 0, 0, 0, scale * n[0], scale * n[1], scale * n[2]);
    }

    private void add(int row, JointedBody body, double lx, double ly, double lz, double ax, double ay, double az) {
        int at = term(row, body) * NUMBERS;
        jacobian[at] += lx;
        jacobian[at + 1] += ly;
        jacobian[at + 2] += lz;
        jacobian[at + 3] += ax;
        jacobian[at + 4] += ay;
        jacobian[at + 5] += az;
        double mass = body.movable ? body.inverseMass : 0;
        double turns = body.movable ? 1 : 0;
        response[at] += mass * lx;
        response[at + 1] += mass * ly;
        response[at + 2] += mass * lz;
        response[at + 3] += turns * (body.i00 * ax + body.i01 * ay + body.i02 * az);
        response[at + 4] += turns * (body.i01 * ax + body.i11 * ay + body.i12 * az);
        response[at + 5] += turns * (body.i02 * ax + body.i12 * ay + body.i22 * az);
    }

    /** Returns the term of a body in a row, a new one if it has none. */
    private int term(int row, JointedBody body) {
        int end = row * TERMS + terms[row];
        for (int term = row * TERMS; term < end; term++) {
            if (bodies[term] == body) {
                return term;
            }
        }
        terms[row]++;
        bodies[end] = body;
        Arrays.fill(jacobian, end * NUMBERS, (end + 1) * NUMBERS, 0);
        Arrays.fill(response, end * NUMBERS, (end + 1) * NUMBERS, 0);
        return end;
    }

    /** Returns the change of a row's speed per unit impulse at this row. */
    double mobility(int row) {
        double sum = 0;
        for (int i = row * TERMS; i < row * TERMS + terms[row]; i++) {
            sum += product(i * NUMBERS, i * NUMBERS);
        }
        return sum;
    }

    /**
     * Returns the change of speed at one row per unit impulse at another.
     * @param pairs what {@link #couple} has added for both rows, from one number up to another
     */
    double mobility(int[] pairs, int from, int to) {
        double sum = 0;
        for (int i = from; i < to; i += 2) {
            sum += product(pairs[i], pairs[i + 1]);
        }
        return sum;
    }

    private double product(int p, int q) {
        return jacobian[p] * response[q] + jacobian[p + 1] * response[q + 1] + jacobian[p + 2] * response[q + 2]
            + jacobian[p + 3] * response[q + 3] + jacobian[p + 4] * response[q + 4] + jacobian[p + 5] * response[q + 5];
    }

    /** Adds the places of two rows' terms of common bodies that can move. They stay while the joints do. */
    void couple(int row, int other, List<Integer> pairs) {
        for (int i = row * TERMS; i < row * TERMS + terms[row] && !measuring[row]; i++) {
            for (int k = other * TERMS; k < other * TERMS + terms[other] && !measuring[other]; k++) {
                if (bodies[i] == bodies[k] && bodies[i].inverseMass > 0) {
                    pairs.add(i * NUMBERS);
                    pairs.add(k * NUMBERS);
                }
            }
        }
    }

    /** Returns the speed of a row, m/s or rad/s. */
    double speed(int row) {
        double sum = 0;
        for (int i = row * TERMS; i < row * TERMS + terms[row]; i++) {
            double[] v = bodies[i].v;
            int p = i * NUMBERS;
            sum += jacobian[p] * v[0] + jacobian[p + 1] * v[1] + jacobian[p + 2] * v[2] + jacobian[p + 3] * v[3]
                + jacobian[p + 4] * v[4]
                + jacobian[p + 5] * v[5];
        }
        return sum;
    }

    /** Returns by how much the speed of a row falls short. */
    double missing(int row) {
        return target[row] - softness[row] * impulse[row] - speed(row);
    }

    /** Adds to a row's impulse. */
    void push(int row, double change) {
        impulse[row] += change;
        apply(row, change);
    }

    /** Applies an impulse to the velocities of a row's bodies. */
    void apply(int row, double change) {
        for (int i = row * TERMS; i < row * TERMS + terms[row]; i++) {
            add(bodies[i].v, i * NUMBERS, change);
        }
    }

    /** Adds to the position correction of a row's bodies. */
    void shift(int row, double amount) {
        for (int i = row * TERMS; i < row * TERMS + terms[row]; i++) {
            add(bodies[i].correction, i * NUMBERS, amount);
        }
    }

    private void add(double[] into, int from, double amount) {
        for (int k = 0; k < NUMBERS; k++) {
            into[k] += response[from + k] * amount;
        }
    }
}
