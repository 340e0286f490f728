// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

import java.util.Arrays;
import org.SEAR.geometry.Placement;

/**
 * Motion, mass and inertia of a rigid body, as constraints see them. The frame has its origin in the centre of mass.
 * Simulation thread.
 */
public abstract class JointedBody {
    /**
     * Velocities of the centre of mass, world frame: {vx, vy, vz, wx, wy, wz}, m/s and rad/s. Constraints change them.
     */
    public final double[] v = new double[6];
    /** Pseudo-velocities of position corrections, as {@link #v} times seconds: metres and radians, world frame. */
    public final double[] correction = new double[6];
    /** Pose in the world. */
    public final Placement place = new Placement();
    /** 1/kg; 0 for a body that never moves. */
    public double inverseMass;
    /** Inverse inertia tensor in the world, 1/(kg m^2): a symmetric matrix. */
    public double i00;
    public double i01;
    public double i02;
    public double i11;
    public double i12;
    public double i22;
    /** Whether constraints move it in this step. */
    public boolean movable;

    /** Notes that a constraint acts on it in this substep. */
    public abstract void hold();

    /** Moves it by {@link #correction}, which it clears. */
    public abstract void correct();

    /** The world as the end of a joint: it never moves. */
    static final class World extends JointedBody {
        @Override
        public void hold() {
            // it does not move
        }

        @Override
        public void correct() {
            Arrays.fill(correction, 0);
        }
    }
}
