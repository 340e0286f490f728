// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

/**
 * Levers by which the rows of a contact turn the hinges of both bodies; 0 without a hinge. Levers are positive where
 * the surfaces approach as the hinge turns. Simulation thread.
 */
public final class HingeLevers {
    private final double[] ofA;
    private final double[] ofB;
    private Hinge a;
    private Hinge b;

    /** @param rows number of rows */
    public HingeLevers(int rows) {
        ofA = new double[rows];
        ofB = new double[rows];
    }

    /** Sets the hinges of both bodies; null without a hinge. */
    public void set(Hinge first, Hinge second) {
        a = first;
        b = second;
    }

    /** Whether there is a hinge. */
    public boolean any() {
        return a != null || b != null;
    }

    /** Sets the levers of a row, metres. */
    public void setRow(int row, double first, double second) {
        ofA[row] = first;
        ofB[row] = second;
    }

    /** Subtracts the levers of another row. */
    public void subtract(int row, int other) {
        ofA[row] -= ofA[other];
        ofB[row] -= ofB[other];
    }

    /** Returns the approach speed along a row beyond the plan, m/s. */
    public double speed(int row) {
        return (a == null ? 0 : ofA[row] * a.deviation()) + (b == null ? 0 : ofB[row] * b.deviation());
    }

    /** Returns the approach along a row beyond the plan in this step, metres. */
    public double way(int row) {
        return (a == null ? 0 : ofA[row] * a.ahead()) + (b == null ? 0 : ofB[row] * b.ahead());
    }

    /**
     * Returns the effective mass of a row with yielding hinges, kg.
     * @param rigid effective mass without them, kg
     */
    public double mass(int row, double rigid) {
        double yields = (a == null ? 0 : a.yields(ofA[row])) + (b == null ? 0 : b.yields(ofB[row]));
        return rigid / (1 + rigid * yields);
    }

    /** Applies a separating impulse along a row to the hinges, N s. */
    public void push(int row, double impulse) {
        if (a != null) {
            a.push(ofA[row], impulse);
        }
        if (b != null) {
            b.push(ofB[row], impulse);
        }
    }
}
