// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.collision.WheelTouch;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.SolverBody;

/**
 * Second contact of a wheel, as with a kerb in front of it or the other edge of a gap. It takes up to the whole force
 * of the spring from the first contact, and so stops the axle across the suspension. Stronger forces lift the wheel
 * onto it. Simulation thread.
 */
final class Wedge {
    /** Square of the smallest difference of both normals. */
    private static final double MIN_SQUARE = 1e-4;

    private final Vec3 along = new Vec3();
    private final Vec3 axle = new Vec3();
    private final ConstraintRow row = new ConstraintRow();
    private Body body;
    /** Force per force of the spring. */
    private double factor;
    private double room;
    private double allowed;

    /**
     * Sets the contacts, once per step.
     * @param newAxle position of the axle, world frame
     * @param second contact; null for none
     * @param lead predicted displacement in this step, for which the contacts were found, metres
     */
    void look(RaycastScenes scenes, Vec3 newAxle, WheelTouch first, WheelTouch second, Vec3 lead) {
        body = null;
        row.impulse = 0;
        if (second == null || !(second.normal.y > 0)) {
            return;
        }
        along.set(0, 0, 0).add(1 / second.lean, second.normal).add(-1 / first.lean, first.normal);
        double square = along.dot(along);
        if (square < MIN_SQUARE) {
            return;
        }
        factor = Math.sqrt(square);
        along.scale(1 / factor);
        room = (first.height - second.height) / factor - along.dot(lead);
        axle.set(newAxle);
        body = scenes.body(second.shape);
    }

    void prepare(SolverBody robot) {
        if (body == null) {
            return;
        }
        SolverBody other = body.solver();
        row.set(along.x, along.y, along.z, axle.x, axle.y, axle.z, robot, other);
        row.impulse = 0;
        allowed = Obstacle.allowed(left(robot), robot.seconds());
    }

    private double left(SolverBody robot) {
        double left = room + robot.travel(along.x, along.y, along.z, axle.x, axle.y, axle.z);
        SolverBody other = body.solver();
        return other == null ? left : left - other.travel(along.x, along.y, along.z, axle.x, axle.y, axle.z);
    }

    /** Returns by how much the second contact shortens the suspension after the step, metres. */
    double lift(SolverBody robot) {
        return body == null ? 0 : factor * Math.max(0, -left(robot));
    }

    /**
     * Solves one pass.
     * @param v velocities of the robot's centre of mass, changed
     * @param spring impulse of the spring, N s
     */
    void solve(double[] v, double spring) {
        if (body != null) {
            row.add(v, (allowed - row.speed(v)) / row.mobility, 0, factor * spring);
        }
    }

    /** Supporting body of the second contact; null for none. */
    Body body() {
        return body;
    }
}
