// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import org.SEAR.geometry.InertiaTensor;

/** Convex solid in its own frame. Implementations are immutable. */
public interface ConvexShape {
    /**
     * Finds the support point: the point furthest in a direction.
     * @param dx direction of any length but 0, likewise dy and dz
     * @param into takes {x, y, z}, metres
     */
    void support(double dx, double dy, double dz, double[] into);

    /**
     * Finds the contact feature in a direction.
     * @param dx unit direction, likewise dy and dz
     * @param into must be empty
     */
    void feature(double dx, double dy, double dz, ContactFeature into);

    /** Volume, m^3. */
    double volume();

    /** Centre of mass at uniform density: {x, y, z}, metres. */
    double[] centre();

    /** Inertia tensor of one kilogram at uniform density about {@link #centre}, m^2. */
    InertiaTensor inertia();

    /** Upper bound of the distance from the origin to the furthest point, metres. */
    double radius();

    /** Smallest half extent, metres. */
    double least();

    /** Whether it can roll. */
    default boolean isRound() {
        return true;
    }

    /** Whether it has a round rim. */
    default boolean isRimmed() {
        return false;
    }

    /** Whether it is symmetrical about its y axis. */
    default boolean isTurned() {
        return false;
    }

    /** Whether a surface point is or may be a corner: a contact there moves along with the rotation. */
    default boolean isCorner(double x, double y, double z) {
        return !isRound();
    }

    /** Whether it is a sphere. */
    default boolean isBall() {
        return false;
    }

    /**
     * Finds the support point of the core: the shape without its convex radius {@link #skin}, with the same normals.
     * Cores of touching bodies are apart, so that the contact normal stays exact at zero distance.
     * @param into takes {x, y, z}, metres
     */
    void coreSupport(double dx, double dy, double dz, double[] into);

    /** Convex radius: distance from the core's faces to the shape's, metres. */
    double skin();
}
