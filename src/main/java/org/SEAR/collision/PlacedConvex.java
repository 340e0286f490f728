// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import org.SEAR.geometry.Placement;

/** Convex solid at a pose in the world. Not thread-safe. */
public final class PlacedConvex implements Convex {
    private ConvexShape shape;
    private final Placement at = new Placement();
    private final Convex core = this::coreSupport;

    /**
     * Sets the shape.
     * @return its pose, to be set by the caller
     */
    public Placement set(ConvexShape newShape) {
        shape = newShape;
        return at;
    }

    @Override
    public void support(double dx, double dy, double dz, double[] into) {
        shape.support(at.m00 * dx + at.m10 * dy + at.m20 * dz, at.m01 * dx + at.m11 * dy + at.m21 * dz,
            at.m02 * dx + at.m12 * dy + at.m22 * dz, into);
        at.transform(into[0], into[1], into[2], into, 0);
    }

    /** Finds the contact feature in a unit direction, both in the world. */
    public void feature(double dx, double dy, double dz, ContactFeature into) {
        into.clear();
        shape.feature(at.m00 * dx + at.m10 * dy + at.m20 * dz, at.m01 * dx + at.m11 * dy + at.m21 * dz,
            at.m02 * dx + at.m12 * dy + at.m22 * dz, into);
        into.place(at);
    }

    /** Core in the world, see {@link ConvexShape#coreSupport}. */
    public Convex core() {
        return core;
    }

    private void coreSupport(double dx, double dy, double dz, double[] into) {
        shape.coreSupport(at.m00 * dx + at.m10 * dy + at.m20 * dz, at.m01 * dx + at.m11 * dy + at.m21 * dz,
            at.m02 * dx + at.m12 * dy + at.m22 * dz, into);
        at.transform(into[0], into[1], into[2], into, 0);
    }
}
