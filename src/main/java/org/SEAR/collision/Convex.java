package org.SEAR.collision;

/** A convex set that stands in the world. */
public interface Convex {
    /**
     * Its support point: the point of it that is farthest in a direction, which need not be of length 1.
     *
     * @param into takes {x, y, z}, world frame, metres
     */
    void support(double dx, double dy, double dz, double[] into);
}
