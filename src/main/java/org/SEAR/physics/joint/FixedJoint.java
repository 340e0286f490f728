// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

/** Fixed joint: both bodies move as one, until the joint breaks. Simulation thread. */
public final class FixedJoint extends Joint {
    /** See {@link Joint#Joint}. */
    public FixedJoint(JointedBody a, JointedBody b) {
        super(a, b);
    }

    @Override
    int rows() {
        return 2 * BallJoint.POINT_ROWS;
    }

    @Override
    void fill(JointRows rows, int at, double seconds) {
        BallJoint.fillPoint(this, rows, at);
        BallJoint.fillAxes(this, rows, at + BallJoint.POINT_ROWS);
    }

    @Override
    void measure(JointRows rows, int at) {
        BallJoint.measurePoint(this, rows, at);
        BallJoint.measureAxes(this, rows, at + BallJoint.POINT_ROWS);
    }

    @Override
    void note(JointRows rows, int at) {
        BallJoint.notePoint(this, rows, at);
        BallJoint.noteAxes(this, rows, at + BallJoint.POINT_ROWS);
    }
}
