package org.SEAR.physics;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.collision.ManifoldClipper;
import org.SEAR.geometry.TimeStep;

/**
 * What stands so near to a robot's body that it may be reached within a step: the body comes as far as the surface, not into it. jbullet's own
 * contacts work only from the touch on. Simulation thread.
 */
public final class ApproachConstraints {
    /** How far from the surface it stops, metres: where jbullet's contact has taken over. */
    private static final double STOP = ManifoldClipper.SKIN / 2;

    /** Of all points in an iteration of the solver. */
    private static final int SWEEPS = 4;

    private final List<One> all = new ArrayList<>();
    private int count;
    private final double[] speed = new double[3];

    /** One point of a surface. */
    private static final class One {
        final ConstraintRow row = new ConstraintRow();
        Body other;
        double nx;
        double ny;
        double nz;
        double x;
        double y;
        double z;
        double gap;
        double allowed;
        double yielding;
        double wanted;
    }

    /** Forgets those of the last step. */
    public void clear() {
        count = 0;
    }

    void add(Body other, double nx, double ny, double nz, double x, double y, double z, double gap) {
        if (count == all.size()) {
            all.add(new One());
        }
        One one = all.get(count++);
        one.other = other;
        one.nx = nx;
        one.ny = ny;
        one.nz = nz;
        one.x = x;
        one.y = y;
        one.z = z;
        one.gap = gap;
    }

    /**
     * Makes the rows of a step.
     *
     * @param body the robot's
     */
    public void prepare(SolverBody body) {
        for (int i = 0; i < count; i++) {
            One one = all.get(i);
            one.row.set(one.nx, one.ny, one.nz, one.x + one.gap * one.nx, one.y + one.gap * one.ny, one.z + one.gap * one.nz, body);
            one.row.impulse = 0;
            one.allowed = -(one.gap - STOP) / TimeStep.SECONDS;
            one.yielding = one.other.isFixed() ? 0 : 1 / one.other.mass;
            if (!one.other.isFixed()) {
                one.other.velocityAt(one.x, one.y, one.z, speed);
                one.allowed += one.nx * speed[0] + one.ny * speed[1] + one.nz * speed[2];
            }
        }
    }

    /**
     * One iteration of the solver. All points take their share at once: one after the other would turn the body.
     *
     * @param v velocities, changed
     */
    public void solve(double[] v) {
        for (int sweep = 0; sweep < SWEEPS && count > 0; sweep++) {
            int pressed = 0;
            for (int i = 0; i < count; i++) {
                One one = all.get(i);
                double apart = one.row.speed(v) + one.yielding * one.row.impulse;
                one.wanted = (one.allowed - apart) / (one.row.mobility + one.yielding);
                pressed += one.wanted > 0 || one.row.impulse > 0 ? 1 : 0;
            }
            for (int i = 0; i < count; i++) {
                One one = all.get(i);
                one.row.add(v, one.wanted / Math.max(1, pressed), 0, Double.POSITIVE_INFINITY);
            }
        }
    }

    public int size() {
        return count;
    }

    /** The body that a point belongs to. */
    public Body body(int i) {
        return all.get(i).other;
    }

    /**
     * What it took to stop there, if that can move.
     *
     * @param impulse takes {x, y, z}, Ns
     * @param at takes the point
     */
    public boolean reaction(int i, double[] impulse, double[] at) {
        One one = all.get(i);
        if (one.other.isFixed() || one.row.impulse == 0) {
            return false;
        }
        impulse[0] = -one.nx * one.row.impulse;
        impulse[1] = -one.ny * one.row.impulse;
        impulse[2] = -one.nz * one.row.impulse;
        at[0] = one.x;
        at[1] = one.y;
        at[2] = one.z;
        return true;
    }
}
