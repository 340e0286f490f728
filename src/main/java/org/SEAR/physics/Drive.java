package org.SEAR.physics;

/** Constraints that a robot's wheels put on its body; jbullet solves them together with the contacts. Simulation thread. */
public interface Drive {
    /** Makes the rows of a step; what is known of their impulses may already act (warm starting). */
    void prepare(SolverBody body);

    /** One iteration: brings the velocities of the body nearer to what the wheels allow. */
    void solve(SolverBody body);
}
