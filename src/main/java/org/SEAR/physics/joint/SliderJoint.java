// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

/** Slider: the second body moves along the y axis of the joint's frame, without turning. Simulation thread. */
public final class SliderJoint extends AxisJoint {
    private static final int SIDES = 2;

    private final double[] across = new double[3];
    private final double[] beside = new double[3];
    private final double[] off = new double[3];

    /** See {@link Joint#Joint}. */
    public SliderJoint(JointedBody a, JointedBody b) {
        super(a, b);
    }

    @Override
    int heldRows() {
        return SIDES + BallJoint.POINT_ROWS;
    }

    @Override
    void measureAxis() {
        axis(onA, 0, across);
        axis(onA, 1, along);
        axis(onA, 2, beside);
        off[0] = onB.x - onA.x;
        off[1] = onB.y - onA.y;
        off[2] = onB.z - onA.z;
        getAxis().setPosition(dot(along, off));
    }

    @Override
    void fillHeld(JointRows rows, int at) {
        for (int i = 0; i < SIDES; i++) {
            rows.begin(at + i);
            rows.linear(at + i, 1, i == 0 ? across : beside, point, a(), b());
        }
        BallJoint.fillAxes(this, rows, at + SIDES);
        measureSides(rows, at);
    }

    @Override
    void measureHeld(JointRows rows, int at) {
        measureSides(rows, at);
        BallJoint.measureAxes(this, rows, at + SIDES);
    }

    private void measureSides(JointRows rows, int at) {
        rows.error[at] = dot(across, off);
        rows.error[at + 1] = dot(beside, off);
    }

    @Override
    void fillAxis(JointRows rows, int row, double scale) {
        rows.linear(row, scale, along, point, a(), b());
    }

    @Override
    void noteHeld(JointRows rows, int at) {
        addForce(across, rows.impulse[at]);
        addForce(beside, rows.impulse[at + 1]);
        BallJoint.noteAxes(this, rows, at + SIDES);
    }

    @Override
    void addAxis(double impulse) {
        addForce(along, impulse);
    }
}
