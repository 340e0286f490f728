// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

/** Hinge: the second body turns about the y axis of the joint's frame. Simulation thread. */
public final class HingeJoint extends AxisJoint {
    private static final int ROWS = 5;

    private final double[] across = new double[3];
    private final double[] beside = new double[3];

    /** See {@link Joint#Joint}. */
    public HingeJoint(JointedBody a, JointedBody b) {
        super(a, b);
    }

    @Override
    int heldRows() {
        return ROWS;
    }

    @Override
    void measureAxis() {
        axis(onA, 1, along);
        double sine = (onB.m02 * onA.m00 + onB.m12 * onA.m10 + onB.m22 * onA.m20 - onB.m00 * onA.m02 - onB.m10 * onA.m12
            - onB.m20 * onA.m22) / 2;
        double cosine = (onB.m00 * onA.m00 + onB.m10 * onA.m10 + onB.m20 * onA.m20 + onB.m02 * onA.m02
            + onB.m12 * onA.m12 + onB.m22 * onA.m22) / 2;
        getAxis().setAngle(Math.atan2(sine, cosine));
    }

    @Override
    void fillHeld(JointRows rows, int at) {
        BallJoint.fillPoint(this, rows, at);
        axis(onA, 0, across);
        axis(onA, 2, beside);
        for (int i = BallJoint.POINT_ROWS; i < ROWS; i++) {
            rows.begin(at + i);
            rows.angular(at + i, 1, i == BallJoint.POINT_ROWS ? across : beside, a(), b());
        }
        measureTilt(rows, at + BallJoint.POINT_ROWS);
    }

    @Override
    void measureHeld(JointRows rows, int at) {
        BallJoint.measurePoint(this, rows, at);
        measureTilt(rows, at + BallJoint.POINT_ROWS);
    }

    /** Measures the angles between the axes on both bodies. */
    private void measureTilt(JointRows rows, int at) {
        axis(onB, 1, second);
        double x = along[1] * second[2] - along[2] * second[1];
        double y = along[2] * second[0] - along[0] * second[2];
        double z = along[0] * second[1] - along[1] * second[0];
        rows.error[at] = across[0] * x + across[1] * y + across[2] * z;
        rows.error[at + 1] = beside[0] * x + beside[1] * y + beside[2] * z;
    }

    @Override
    void fillAxis(JointRows rows, int row, double scale) {
        rows.angular(row, scale, along, a(), b());
    }

    @Override
    void noteHeld(JointRows rows, int at) {
        BallJoint.notePoint(this, rows, at);
        addTorque(across, rows.impulse[at + BallJoint.POINT_ROWS]);
        addTorque(beside, rows.impulse[at + BallJoint.POINT_ROWS + 1]);
    }

    @Override
    void addAxis(double impulse) {
        addTorque(along, impulse);
    }
}
