package org.SEAR.simulator;

import com.bulletphysics.linearmath.Transform;

/** A solid where jbullet has it now; a mesh counts as its convex hull. Simulation thread. */
final class Placed implements Convex {
    private Solid solid;
    private final Transform at = new Transform();
    private final double[] m = new double[9];
    private double x;
    private double y;
    private double z;

    /** @param place copied */
    void set(Solid newSolid, Transform place) {
        solid = newSolid;
        at.set(place);
        m[0] = place.basis.m00;
        m[1] = place.basis.m01;
        m[2] = place.basis.m02;
        m[3] = place.basis.m10;
        m[4] = place.basis.m11;
        m[5] = place.basis.m12;
        m[6] = place.basis.m20;
        m[7] = place.basis.m21;
        m[8] = place.basis.m22;
        x = place.origin.x;
        y = place.origin.y;
        z = place.origin.z;
    }

    @Override
    public void farthest(double dx, double dy, double dz, double[] into) {
        solid.farthestOfHull(m[0] * dx + m[3] * dy + m[6] * dz, m[1] * dx + m[4] * dy + m[7] * dz, m[2] * dx + m[5] * dy + m[8] * dz, into);
        double px = into[0];
        double py = into[1];
        double pz = into[2];
        into[0] = x + m[0] * px + m[1] * py + m[2] * pz;
        into[1] = y + m[3] * px + m[4] * py + m[5] * pz;
        into[2] = z + m[6] * px + m[7] * py + m[8] * pz;
    }

    /** The part of it that faces a direction (of length 1, world frame), in the world. */
    void feature(double dx, double dy, double dz, Feature into) {
        solid.feature(m[0] * dx + m[3] * dy + m[6] * dz, m[1] * dx + m[4] * dy + m[7] * dz, m[2] * dx + m[5] * dy + m[8] * dz, into);
        into.place(at);
    }
}
