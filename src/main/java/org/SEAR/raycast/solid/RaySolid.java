package org.SEAR.raycast.solid;

/**
 * A convex solid, centred in the origin of its own frame, as single beams meet it. Implementations are immutable and allocate nothing here: the loop
 * of beams calls them.
 */
public interface RaySolid {
    /**
     * Where a beam meets its surface, which belongs to it.
     *
     * @param ox origin of the beam, metres, likewise oy and oz
     * @param dx direction of any length but 0, likewise dy and dz
     * @return the distance in units of the direction's length, from inside or on the surface the way out; {@code Double.POSITIVE_INFINITY} where the
     *     beam misses
     */
    double intersect(double ox, double oy, double oz, double dx, double dy, double dz);

    /**
     * The outward normal, of any length but 0.
     *
     * @param point {x, y, z} on the surface, replaced by it
     */
    void normal(double[] point);

    /**
     * How far it reaches from the origin in a direction and in the opposite one, metres, or more.
     *
     * @param dx unit direction, likewise dy and dz
     */
    double reach(double dx, double dy, double dz);
}
