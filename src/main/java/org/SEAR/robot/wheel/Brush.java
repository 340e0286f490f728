// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.SolverBody;

/**
 * Static friction of a tyre in one direction, as a soft constraint: the bristles of a brush bend like a stiff spring
 * until the tyre slips, and a rolling wheel releases them. Several wheels so share the load, and a standing robot
 * returns after a displacement: it does not creep. Solved implicitly. Simulation thread.
 */
final class Brush {
    /**
     * Natural frequency of the wheel's load on this spring, rad/s: on 15 degrees it bends by a quarter of a millimetre.
     */
    private static final double FREQUENCY = 100;

    private final ConstraintRow row;
    private final double stiffness;
    private final double damping;
    private double bent;
    private double softness;
    private double bias;
    private double seconds;

    /**
     * Brush along a row set by the caller.
     * @param carried load of the wheel, kg
     */
    Brush(ConstraintRow row, double carried) {
        this.row = row;
        stiffness = FREQUENCY * FREQUENCY * carried;
        damping = 2 * FREQUENCY * carried;
    }

    /** Begins a substep and applies the last impulse (warm starting). */
    void prepare(SolverBody body) {
        double before = seconds;
        seconds = body.seconds();
        double soft = damping + seconds * stiffness;
        softness = 1 / (seconds * soft);
        bias = stiffness * bent / soft;
        row.impulse *= before > 0 ? seconds / before : 0;
        row.applyImpulse(body.v, row.impulse);
    }

    /**
     * Solves one pass.
     * @param speed of the tyre over the ground, m/s
     * @param most largest impulse, N s
     */
    void solve(double[] v, double speed, double most) {
        row.add(v, -(speed + bias + softness * row.impulse) / (row.mobility + softness), -most, most);
    }

    /**
     * Ends the substep and updates the deflection.
     * @param speed of the tyre over the ground, m/s
     * @param most largest impulse, N s, which limits the deflection
     */
    void bend(double speed, double most) {
        double farthest = most / (seconds * stiffness);
        bent = Math.max(-farthest, Math.min(farthest, bent + speed * seconds));
    }

    /**
     * Releases the bristles as the wheel rolls.
     * @param way distance rolled, metres
     * @param length relaxation length of the tyre, metres
     */
    void roll(double way, double length) {
        bent /= 1 + Math.abs(way) / length;
    }

    /** Releases the bristles while a motor drives along the row. */
    void letGo() {
        bent = 0;
        seconds = 0;
    }

    void release() {
        letGo();
        row.impulse = 0;
    }
}
