// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

/** Convex radius: thickness of a shape's layer around its core, see {@link ConvexShape#coreSupport}. */
final class ConvexRadius {
    /** Largest radius, metres. */
    private static final double MOST = 1e-3;
    /** Largest radius as a share of the smallest half extent. */
    private static final double SHARE = 0.1;

    private ConvexRadius() {
    }

    /** @param least smallest half extent, metres */
    static double of(double least) {
        return Math.min(MOST, SHARE * least);
    }
}
