package org.SEAR.physics.solid;

/**
 * By which levers the rows of a contact turn the hinges of what touches there, of either body; where there is no hinge the lever is 0. Levers are
 * positive where both sides come together as the hinge turns. Simulation thread.
 */
public final class HingeLevers {
    private final double[] ofA;
    private final double[] ofB;
    private Hinge a;
    private Hinge b;

    /** @param rows how many */
    public HingeLevers(int rows) {
        ofA = new double[rows];
        ofB = new double[rows];
    }

    /** Begins with the hinges of both sides; null where there is none. */
    public void set(Hinge first, Hinge second) {
        a = first;
        b = second;
    }

    /** Whether there is one at all. */
    public boolean any() {
        return a != null || b != null;
    }

    /** Sets the levers of a row, metres. */
    public void setRow(int row, double first, double second) {
        ofA[row] = first;
        ofB[row] = second;
    }

    /** Takes the levers of another row off those of a row. */
    public void subtract(int row, int other) {
        ofA[row] -= ofA[other];
        ofB[row] -= ofB[other];
    }

    /** How much faster than planned both sides come together along a row, m/s. */
    public double speed(int row) {
        return (a == null ? 0 : ofA[row] * a.deviation()) + (b == null ? 0 : ofB[row] * b.deviation());
    }

    /** How much farther than planned they have come together in this step, metres. */
    public double way(int row) {
        return (a == null ? 0 : ofA[row] * a.ahead()) + (b == null ? 0 : ofB[row] * b.ahead());
    }

    /** Mass that an impulse along a row meets, kg, when the hinges give way, too. */
    public double mass(int row, double rigid) {
        double yields = (a == null ? 0 : a.yields(ofA[row])) + (b == null ? 0 : b.yields(ofB[row]));
        return rigid / (1 + rigid * yields);
    }

    /** An impulse along a row, Ns, pushes them apart. */
    public void push(int row, double impulse) {
        if (a != null) {
            a.push(ofA[row], impulse);
        }
        if (b != null) {
            b.push(ofB[row], impulse);
        }
    }
}
