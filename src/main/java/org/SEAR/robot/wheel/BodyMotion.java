// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.geometry.TimeStep;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;

/** Motion of a robot's body at the start of a step. Simulation thread. */
final class BodyMotion {
    /** Velocities of the centre of mass, world frame, m/s and rad/s, and the centre itself. */
    private final double[] v = new double[6];
    private final Vec3 centre = new Vec3();
    private double[] own;
    private boolean deep;

    /** Reads the motion of a body. */
    void look(Body body) {
        if (own == null) {
            own = body.getCentre();
        }
        body.velocities(v);
        deep = body.isDeep();
        centre.transform(body.getPose(), own[0], own[1], own[2]);
    }

    /** Whether it overlaps another body deeply. */
    boolean isDeep() {
        return deep;
    }

    /** Returns the speed of the centre of mass along a direction, m/s. */
    double speed(Vec3 along) {
        return v[0] * along.x + v[1] * along.y + v[2] * along.z;
    }

    /**
     * Predicts the displacement of a point in one step.
     * @param point world frame, metres
     * @param up unit direction, world frame
     * @param across takes the displacement at right angles to that direction, metres
     * @return displacement against that direction, metres
     */
    double predict(Vec3 point, Vec3 up, Vec3 across) {
        double x = point.x - centre.x;
        double y = point.y - centre.y;
        double z = point.z - centre.z;
        across.set(v[0] + v[4] * z - v[5] * y, v[1] + v[5] * x - v[3] * z, v[2] + v[3] * y - v[4] * x)
            .scale(TimeStep.SECONDS);
        double down = -across.dot(up);
        across.add(down, up);
        return down;
    }
}
