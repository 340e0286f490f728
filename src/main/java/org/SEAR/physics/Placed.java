package org.SEAR.physics;

import com.bulletphysics.linearmath.Transform;
import org.SEAR.collision.Convex;
import org.SEAR.collision.Feature;
import org.SEAR.geometry.Placement;

/** A solid where jbullet has it now; a mesh counts as its convex hull. Simulation thread. */
final class Placed implements Convex {
    private Solid solid;
    private final Placement at = new Placement();

    /** @param place copied */
    void set(Solid newSolid, Transform place) {
        solid = newSolid;
        toPlacement(place, at);
    }

    /** Copies where jbullet has something. */
    static void toPlacement(Transform from, Placement into) {
        into.m00 = from.basis.m00;
        into.m01 = from.basis.m01;
        into.m02 = from.basis.m02;
        into.m10 = from.basis.m10;
        into.m11 = from.basis.m11;
        into.m12 = from.basis.m12;
        into.m20 = from.basis.m20;
        into.m21 = from.basis.m21;
        into.m22 = from.basis.m22;
        into.x = from.origin.x;
        into.y = from.origin.y;
        into.z = from.origin.z;
    }

    @Override
    public void farthest(double dx, double dy, double dz, double[] into) {
        solid.farthestOfHull(at.m00 * dx + at.m10 * dy + at.m20 * dz, at.m01 * dx + at.m11 * dy + at.m21 * dz,
            at.m02 * dx + at.m12 * dy + at.m22 * dz, into);
        at.transform(into[0], into[1], into[2], into, 0);
    }

    /** The part of it that faces a direction (of length 1, world frame), in the world. */
    void feature(double dx, double dy, double dz, Feature into) {
        solid.feature(at.m00 * dx + at.m10 * dy + at.m20 * dz, at.m01 * dx + at.m11 * dy + at.m21 * dz,
            at.m02 * dx + at.m12 * dy + at.m22 * dz, into);
        into.place(at);
    }
}
