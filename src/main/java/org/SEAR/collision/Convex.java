// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

/** Convex set in the world. */
public interface Convex {
    /**
     * Finds the support point: the point furthest in a direction, which may have any length.
     * @param into takes {x, y, z}, world frame, metres
     */
    void support(double dx, double dy, double dz, double[] into);
}
