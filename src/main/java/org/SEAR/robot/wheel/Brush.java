package org.SEAR.robot.wheel;

import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.SolverBody;

/**
 * Static friction of a tyre in one direction: a stiff spring, as the bristles of a brush, that bends until the tyre slips and that a rolling wheel
 * lets go. So several wheels share what they hold, and what stands comes back when it was moved: it does not creep. Solved implicitly. Simulation
 * thread.
 */
final class Brush {
    /** Natural frequency of what the wheel carries on this spring, rad/s: on 15 degrees it bends by a quarter of a millimetre. */
    private static final double FREQUENCY = 100;

    private final ConstraintRow row;
    private final double stiffness;
    private final double damping;
    private double bent;
    private double softness;
    private double bias;
    private double seconds;

    /**
     * Of a row that is set elsewhere.
     *
     * @param carried by the wheel, kg
     */
    Brush(ConstraintRow row, double carried) {
        this.row = row;
        stiffness = FREQUENCY * FREQUENCY * carried;
        damping = 2 * FREQUENCY * carried;
    }

    /** A substep begins, with the impulse of the last one as the first guess. */
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
     * One pass of the solver.
     *
     * @param speed of the tyre over the ground, m/s
     * @param most impulse, Ns
     */
    void solve(double[] v, double speed, double most) {
        row.add(v, -(speed + bias + softness * row.impulse) / (row.mobility + softness), -most, most);
    }

    /**
     * The substep ends.
     *
     * @param speed of the tyre over the ground, m/s
     * @param most impulse, Ns: the spring bends no farther
     */
    void bend(double speed, double most) {
        double farthest = most / (seconds * stiffness);
        bent = Math.max(-farthest, Math.min(farthest, bent + speed * seconds));
    }

    /**
     * The wheel rolls on, and stands on another part of its tyre.
     *
     * @param way metres
     * @param length over which a tyre forgets, metres
     */
    void roll(double way, double length) {
        bent /= 1 + Math.abs(way) / length;
    }

    /** Something else pushes along its row. */
    void letGo() {
        bent = 0;
        seconds = 0;
    }

    void release() {
        letGo();
        row.impulse = 0;
    }
}
