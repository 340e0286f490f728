// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.collision.ContactFeature;
import org.SEAR.collision.Convex;
import org.SEAR.collision.PlacedConvex;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Placement;
import org.SEAR.physics.solid.Solid;
import org.SEAR.physics.solid.TriangleSearch;

/** Solid of a body at its current world pose, with its bounding box. Simulation thread. */
final class PlacedSolid implements Convex {
    final Solid solid;
    final Placement place;
    private final PlacedConvex convex = new PlacedConvex();
    private final TriangleSearch triangles;
    /** World frame. */
    final Aabb box = new Aabb();
    private final double[] low = new double[3];
    private final double[] high = new double[3];

    PlacedSolid(Solid solid, boolean moves) {
        this.solid = solid;
        triangles = solid.isMesh() && !moves ? solid.triangles() : null;
        place = isMesh() ? new Placement() : convex.set(solid.convex());
    }

    /** Whether it collides by triangles. */
    boolean isMesh() {
        return triangles != null;
    }

    TriangleSearch getTriangles() {
        return triangles;
    }

    @Override
    public void support(double dx, double dy, double dz, double[] into) {
        convex.support(dx, dy, dz, into);
    }

    /** Shape without its convex radius. */
    Convex core() {
        return convex.core();
    }

    /** Finds its feature in a direction, world frame. */
    void feature(double dx, double dy, double dz, ContactFeature into) {
        convex.feature(dx, dy, dz, into);
    }

    /** Updates the box after a change of the pose. */
    void bound() {
        double x = Math.abs(place.m00) * solid.halfX + Math.abs(place.m01) * solid.halfY + Math.abs(place.m02) * solid.halfZ;
        double y = Math.abs(place.m10) * solid.halfX + Math.abs(place.m11) * solid.halfY + Math.abs(place.m12) * solid.halfZ;
        double z = Math.abs(place.m20) * solid.halfX + Math.abs(place.m21) * solid.halfY + Math.abs(place.m22) * solid.halfZ;
        box.set(0, place.x - x, place.x + x).set(1, place.y - y, place.y + y).set(2, place.z - z, place.z + z);
    }

    /** Returns the largest separation of both boxes along a coordinate axis, metres; negative if they overlap. */
    double gap(PlacedSolid other) {
        double most = Double.NEGATIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            most = Math.max(most, Math.max(box.min(axis) - other.box.max(axis), other.box.min(axis) - box.max(axis)));
        }
        return most;
    }

    /**
     * Computes the bounding box of another solid in this one's frame.
     * @param margin by which it is wider, metres
     */
    void inFrame(PlacedSolid other, double margin, Aabb into) {
        for (int axis = 0; axis < 3; axis++) {
            double x = axis == 0 ? place.m00 : axis == 1 ? place.m01 : place.m02;
            double y = axis == 0 ? place.m10 : axis == 1 ? place.m11 : place.m12;
            double z = axis == 0 ? place.m20 : axis == 1 ? place.m21 : place.m22;
            other.support(-x, -y, -z, low);
            other.support(x, y, z, high);
            into.set(axis, x * (low[0] - place.x) + y * (low[1] - place.y) + z * (low[2] - place.z) - margin,
                x * (high[0] - place.x) + y * (high[1] - place.y) + z * (high[2] - place.z) + margin);
        }
    }
}
