package org.SEAR.collision;

import org.SEAR.geometry.Placement;

/** A convex solid at a place in the world. Not for several threads. */
public final class PlacedConvex implements Convex {
    private ConvexShape shape;
    private final Placement at = new Placement();
    private final Convex core = this::coreSupport;

    /**
     * Takes a shape.
     *
     * @return where it stands, to be set by the caller
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

    /** The part of it that faces a direction (of length 1, world frame), in the world. */
    public void feature(double dx, double dy, double dz, ContactFeature into) {
        into.clear();
        shape.feature(at.m00 * dx + at.m10 * dy + at.m20 * dz, at.m01 * dx + at.m11 * dy + at.m21 * dz,
            at.m02 * dx + at.m12 * dy + at.m22 * dz, into);
        into.place(at);
    }

    /** Its core, see {@link ConvexShape#coreSupport}, where it stands. */
    public Convex core() {
        return core;
    }

    private void coreSupport(double dx, double dy, double dz, double[] into) {
        shape.coreSupport(at.m00 * dx + at.m10 * dy + at.m20 * dz, at.m01 * dx + at.m11 * dy + at.m21 * dz,
            at.m02 * dx + at.m12 * dy + at.m22 * dz, into);
        at.transform(into[0], into[1], into[2], into, 0);
    }
}
