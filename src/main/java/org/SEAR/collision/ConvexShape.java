package org.SEAR.collision;

/** A convex solid in its own frame. Implementations are immutable. */
public interface ConvexShape {
    /**
     * Its support point: the point of it that is farthest in a direction.
     *
     * @param dx direction of any length but 0, likewise dy and dz
     * @param into takes {x, y, z}, metres
     */
    void support(double dx, double dy, double dz, double[] into);

    /**
     * The part of its surface that faces a direction.
     *
     * @param dx unit direction, likewise dy and dz
     * @param into empty before
     */
    void feature(double dx, double dy, double dz, ContactFeature into);

    /** Cubic metres. */
    double volume();

    /** Where a body has the mass of this: {x, y, z}, metres. */
    double[] centre();
}
