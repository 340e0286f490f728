package org.SEAR.physics;

/** One point at which two bodies touch or may touch within the step; the direction is the manifold's. Simulation thread. */
final class ContactPoint {
    /** On the second body, world frame, when it was found, metres. */
    double x;
    double y;
    double z;
    /** Of both bodies when it was found, metres; negative: so deep they are in each other. */
    double found;
    /** The same point in the frames of both bodies, by which it is known again. */
    final double[] inA = new double[3];
    final double[] inB = new double[3];
    /** Push of the last substep, Ns. */
    double impulse;
    /** Distance of both surfaces here at the end of the last step, metres. */
    double gap;

    /** The square of the distance from another point, in the frame in which both are nearer, m^2. */
    double square(ContactPoint other) {
        return Math.min(square(inA, other.inA), square(inB, other.inB));
    }

    private static double square(double[] p, double[] q) {
        return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]);
    }
}
