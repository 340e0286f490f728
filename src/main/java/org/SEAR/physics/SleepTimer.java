// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.geometry.TimeStep;

/**
 * Sleep timer: whether a body has hardly moved for half a second. It uses the displacement over that time, not the
 * momentary speed: jitter in a stack is faster than a ball just after its release. Simulation thread.
 */
final class SleepTimer {
    /** Steps at rest before sleep: half a second. */
    private static final int STEPS = 30;
    private static final double SECONDS = STEPS * TimeStep.SECONDS;
    /**
     * Steepest slope, radians, on which a ball released from rest may sleep. A long pole that leans as far past its
     * balance accelerates at 1.05 times the ball's rate, a short one faster.
     */
    private static final double SLOPE = Math.toRadians(0.01);
    /**
     * Largest displacement of the centre of mass, and of the furthest point by rotation, per gravity, s^2: that of the
     * ball in this time, 0.15 mm on Earth. Slower creep, below 0.3 mm/s, is rest.
     */
    private static final double OBJECT = 5.0 / 7 * SLOPE * SECONDS * SECONDS / 2;
    /** Upper limit of the same for robots, metres: slow ones drive at millimetres per second. */
    private static final double ROBOT = 5e-5;
    /** Largest speed at the end, m/s; a faster body is at a turning point, not at rest. */
    private static final double SPEED = 0.02;

    private double x;
    private double y;
    private double z;
    private double qx;
    private double qy;
    private double qz;
    private double qw;
    private int steps;

    /** Restarts the timer. */
    void begin(SolverBody body) {
        steps = 0;
        x = body.place.x;
        y = body.place.y;
        z = body.place.z;
        qx = body.spin().qx();
        qy = body.spin().qy();
        qz = body.spin().qz();
        qw = body.spin().qw();
    }

    /**
     * Checks a body after a step.
     * @param gravity m/s^2
     */
    void look(Body body, double gravity) {
        double band = body.isRobot() ? Math.min(ROBOT, OBJECT * gravity) : OBJECT * gravity;
        if (body.isDriven() || hasLeft(body.getSolver(), band, body.getReach())) {
            begin(body.getSolver());
        } else {
            steps++;
        }
    }

    private boolean hasLeft(SolverBody body, double band, double reach) {
        double dx = body.place.x - x;
        double dy = body.place.y - y;
        double dz = body.place.z - z;
        // vector part of the rotation since then: half of its angle
        double rx = qw * body.spin().qx() - qx * body.spin().qw() - qy * body.spin().qz() + qz * body.spin().qy();
        double ry = qw * body.spin().qy() + qx * body.spin().qz() - qy * body.spin().qw() - qz * body.spin().qx();
        double rz = qw * body.spin().qz() - qx * body.spin().qy() + qy * body.spin().qx() - qz * body.spin().qw();
        double turn = band / reach / 2;
        double[] v = body.v;
        return dx * dx + dy * dy + dz * dz > band * band || rx * rx + ry * ry + rz * rz > turn * turn
            || v[0] * v[0] + v[1] * v[1] + v[2] * v[2] > SPEED * SPEED;
    }

    /** Whether the body has rested long enough to sleep. */
    boolean isOver() {
        return steps >= STEPS;
    }
}
