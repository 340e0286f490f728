// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

/** Ball joint: both bodies turn freely about a common point. Simulation thread. */
public final class BallJoint extends Joint {
    /** Rows of a common point. */
    static final int POINT_ROWS = 3;
    private static final double[][] AXES = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    /** See {@link Joint#Joint}. */
    public BallJoint(JointedBody a, JointedBody b) {
        super(a, b);
    }

    @Override
    int rows() {
        return POINT_ROWS;
    }

    @Override
    void fill(JointRows rows, int at, double seconds) {
        fillPoint(this, rows, at);
    }

    @Override
    void measure(JointRows rows, int at) {
        measurePoint(this, rows, at);
    }

    @Override
    void note(JointRows rows, int at) {
        notePoint(this, rows, at);
    }

    /** Sets up three rows that keep the origins of both frames together. */
    static void fillPoint(Joint of, JointRows rows, int at) {
        for (int i = 0; i < POINT_ROWS; i++) {
            rows.begin(at + i);
            rows.linear(at + i, 1, AXES[i], of.point, of.a(), of.b());
        }
        measurePoint(of, rows, at);
    }

    static void measurePoint(Joint of, JointRows rows, int at) {
        rows.error[at] = of.onB.x - of.onA.x;
        rows.error[at + 1] = of.onB.y - of.onA.y;
        rows.error[at + 2] = of.onB.z - of.onA.z;
    }

    static void notePoint(Joint of, JointRows rows, int at) {
        for (int i = 0; i < POINT_ROWS; i++) {
            of.addForce(AXES[i], rows.impulse[at + i]);
        }
    }

    /** Sets up three rows that keep the axes of both frames parallel. */
    static void fillAxes(Joint of, JointRows rows, int at) {
        for (int i = 0; i < POINT_ROWS; i++) {
            rows.begin(at + i);
            rows.angular(at + i, 1, AXES[i], of.a(), of.b());
        }
        measureAxes(of, rows, at);
    }

    /** The rotation of the second frame against the first is half the sum of the cross products of their axes. */
    static void measureAxes(Joint of, JointRows rows, int at) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = 0; i < POINT_ROWS; i++) {
            axis(of.onA, i, of.first);
            axis(of.onB, i, of.second);
            x += of.first[1] * of.second[2] - of.first[2] * of.second[1];
            y += of.first[2] * of.second[0] - of.first[0] * of.second[2];
            z += of.first[0] * of.second[1] - of.first[1] * of.second[0];
        }
        rows.error[at] = x / 2;
        rows.error[at + 1] = y / 2;
        rows.error[at + 2] = z / 2;
    }

    static void noteAxes(Joint of, JointRows rows, int at) {
        for (int i = 0; i < POINT_ROWS; i++) {
            of.addTorque(AXES[i], rows.impulse[at + i]);
        }
    }
}
