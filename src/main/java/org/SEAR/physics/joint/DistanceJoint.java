// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

import org.SEAR.geometry.Pose;

/**
 * Distance of a point of each body: a rope with an upper limit, a rod with equal limits, a spring, or a winch with a
 * drive. Simulation thread.
 */
public final class DistanceJoint extends AxisJoint {
    /** Distance below which the direction is undefined, metres; the last one is kept. */
    private static final double LEAST = 1e-9;

    /** See {@link Joint#Joint}. */
    public DistanceJoint(JointedBody a, JointedBody b) {
        super(a, b);
        along[1] = 1;
    }

    /** Fixes the ends at points of the world: a point of the first body, and one of the second. */
    public void attachEnds(Pose onFirst, Pose onSecond) {
        attach(onFirst, onSecond);
    }

    @Override
    int heldRows() {
        return 0;
    }

    @Override
    void measureAxis() {
        double x = onB.x - onA.x;
        double y = onB.y - onA.y;
        double z = onB.z - onA.z;
        double distance = Math.sqrt(x * x + y * y + z * z);
        if (distance > LEAST) {
            along[0] = x / distance;
            along[1] = y / distance;
            along[2] = z / distance;
        }
        getAxis().setPosition(distance);
    }

    @Override
    void fillHeld(JointRows rows, int at) {
        // no direction is held
    }

    @Override
    void measureHeld(JointRows rows, int at) {
        // no direction is held
    }

    @Override
    void noteHeld(JointRows rows, int at) {
        // no direction is held
    }

    @Override
    void fillAxis(JointRows rows, int row, double scale) {
        rows.linear(row, scale, along, point, a(), b());
    }

    @Override
    void addAxis(double impulse) {
        addForce(along, impulse);
    }
}
