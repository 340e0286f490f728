// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

/**
 * Joint with one free direction: the rows that hold the others come first, those of the axis last. Simulation thread.
 */
public abstract class AxisJoint extends Joint {
    private final JointAxis axis = new JointAxis();
    /** The free direction: a unit vector, world frame. */
    final double[] along = new double[3];
    private JointRows filled;
    private double start;
    private final JointAxis.Direction direction = (row, scale) -> fillAxis(filled, row, scale);

    AxisJoint(JointedBody a, JointedBody b) {
        super(a, b);
    }

    /** The free direction. */
    public final JointAxis getAxis() {
        return axis;
    }

    /** @param position at which it is attached, metres or radians */
    public final void setStart(double position) {
        start = position;
    }

    /** Number of rows that hold the other directions. */
    abstract int heldRows();

    /** Sets up the rows of the other directions. */
    abstract void fillHeld(JointRows rows, int at);

    /** Sets up a row along the axis. */
    abstract void fillAxis(JointRows rows, int row, double scale);

    /** Measures the errors of the other directions. */
    abstract void measureHeld(JointRows rows, int at);

    /** Notes the impulses of the other directions. */
    abstract void noteHeld(JointRows rows, int at);

    /** Adds an impulse along the axis. */
    abstract void addAxis(double impulse);

    /** Measures direction and position from both frames. */
    abstract void measureAxis();

    /** Measures its axis at the bodies' present poses. */
    final void locate() {
        follow();
        measureAxis();
    }

    @Override
    final int rows() {
        return heldRows() + axis.rows();
    }

    @Override
    final JointAxis servo() {
        return axis.servoRow() < 0 ? null : axis;
    }

    @Override
    final int servoRow() {
        return heldRows() + axis.servoRow();
    }

    @Override
    final boolean isStale() {
        return axis.isStale();
    }

    @Override
    void restart() {
        super.restart();
        axis.restart(start);
        axis.fresh();
        measureAxis();
    }

    @Override
    final void beginStep() {
        super.beginStep();
        axis.beginStep();
    }

    @Override
    final void endStep(double seconds) {
        axis.endStep(seconds);
    }

    @Override
    final void fill(JointRows rows, int at, double seconds) {
        filled = rows;
        axis.fresh();
        measureAxis();
        fillHeld(rows, at);
        axis.fill(rows, at + heldRows(), direction, seconds);
    }

    @Override
    final void measure(JointRows rows, int at) {
        measureAxis();
        measureHeld(rows, at);
        axis.measure(rows, at + heldRows());
    }

    @Override
    final void note(JointRows rows, int at) {
        noteHeld(rows, at);
        addAxis(axis.note(rows, at + heldRows()));
    }
}
