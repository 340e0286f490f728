// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.SolverBody;

/**
 * Spring of one wheel as a soft constraint, solved implicitly and stable at any stiffness, and the stop at the end of
 * its travel. Its row lies along the contact normal: a motion by 1 there moves the spring by 1 / cosine, and its force
 * is that of the spring / cosine. Simulation thread.
 */
final class Suspension {
    /** Rate of the position correction beyond the stop, 1/s. */
    private static final double CORRECTION = 12;

    private final Spring of;
    private final ConstraintRow spring = new ConstraintRow();
    private final ConstraintRow stop = new ConstraintRow();
    private double softness;
    private double bias;
    private double allowed;
    private double mostImpulse;
    private double seconds;

    Suspension(Spring of) {
        this.of = of;
    }

    /** Releases the wheel in the air. */
    void release() {
        spring.impulse = 0;
        stop.impulse = 0;
    }

    /** Sets up the rows of a substep and applies the last impulses (warm starting). */
    void prepare(GroundContact ground, SolverBody body) {
        double before = seconds;
        seconds = body.seconds();
        aim(spring, ground, body, before);
        aim(stop, ground, body, before);
        double share = ground.share();
        double lean = ground.lean();
        double along = share / (lean * lean);
        double stiffness = along * of.stiffness;
        double damping = along * (spring.speed(body.v) < 0 ? of.compressing : of.releasing);
        double soft = damping + seconds * stiffness;
        double gap = ground.gap();
        softness = soft > 0 ? 1 / (seconds * soft) : 0;
        bias = soft > 0 ? stiffness * Math.min(of.rest * lean, of.rest * lean - gap) / soft : 0;
        allowed = gap > 0 ? -gap / seconds : -CORRECTION * share * gap;
        mostImpulse = share / lean * of.mostForce * seconds;
        spring.applyImpulse(body.v, spring.impulse);
        stop.applyImpulse(body.v, stop.impulse);
    }

    private void aim(ConstraintRow row, GroundContact ground, SolverBody body, double before) {
        ground.aim(row, ground.normal, body);
        row.impulse *= before > 0 ? seconds / before : 0;
    }

    /** @param v velocities of the centre of mass, changed */
    void solve(double[] v) {
        if (softness > 0) {
            double error = spring.speed(v) - bias + softness * spring.impulse;
            spring.add(v, -error / (spring.mobility + softness), 0, mostImpulse);
        }
        stop.add(v, -(stop.speed(v) - allowed) / stop.mobility, 0, Double.POSITIVE_INFINITY);
    }

    /** Impulse of the ground on the wheel, N s. */
    double impulse() {
        return spring.impulse + stop.impulse;
    }

    /** Length without load, metres; see {@link Spring#rest}. */
    double rest() {
        return of.rest;
    }
}
