// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

/**
 * A convex solid, centred at the origin of its own frame, for intersection with single rays. Implementations are
 * immutable and allocate nothing in these methods, which the ray loop calls.
 */
public interface RaySolid {
    /**
     * Returns the distance to the surface, which belongs to the solid.
     * @param ox origin of the ray, metres, likewise oy and oz
     * @param dx direction of any length but 0, likewise dy and dz
     * @return the distance in lengths of the direction; from inside or on the surface, the exit distance;
     *     {@code Double.POSITIVE_INFINITY} for a miss
     */
    double intersect(double ox, double oy, double oz, double dx, double dy, double dz);

    /**
     * Replaces a surface point by the outward normal, of any length but 0.
     * @param point {x, y, z} on the surface
     */
    void normal(double[] point);

    /**
     * Returns the maximum extent from the origin along a direction and its opposite, metres, or an upper bound.
     * @param dx unit direction, likewise dy and dz
     */
    double reach(double dx, double dy, double dz);
}
