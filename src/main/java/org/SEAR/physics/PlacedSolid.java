// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.collision.ContactFeature;
import org.SEAR.collision.Convex;
import org.SEAR.collision.ConvexShape;
import org.SEAR.collision.PlacedConvex;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Placement;
import org.SEAR.physics.solid.Solid;
import org.SEAR.physics.solid.TriangleSearch;

/** Solid of a body, or one of its convex parts, at its current world pose, with its bounding box. Simulation thread. */
final class PlacedSolid implements Convex {
    final Solid solid;
    final Placement place;
    /** Index of the solid in its body. */
    final int number;
    /** Part of the solid that collides; null if it collides by triangles. */
    final ConvexShape shape;
    private final PlacedConvex convex = new PlacedConvex();
    private final TriangleSearch triangles;
    /** World frame. */
    final Aabb box = new Aabb();
    /** Centre of the shape's bounding box and its half extents, in the solid's frame. */
    private final double[] middle = new double[3];
    private final double[] half;
    private final double[] low = new double[3];
    private final double[] high = new double[3];

    private PlacedSolid(Solid solid, int number, ConvexShape shape) {
        this.solid = solid;
        this.number = number;
        this.shape = shape;
        half = new double[] {solid.halfX, solid.halfY, solid.halfZ};
        triangles = shape == null ? solid.triangles() : null;
        place = isMesh() ? new Placement() : convex.set(shape);
        for (int axis = 0; axis < 3 && !isMesh() && solid.pieces().size() > 1; axis++) {
            shape.support(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0, high);
            shape.support(axis == 0 ? -1 : 0, axis == 1 ? -1 : 0, axis == 2 ? -1 : 0, low);
            middle[axis] = (high[axis] + low[axis]) / 2;
            half[axis] = (high[axis] - low[axis]) / 2;
        }
    }

    /** Returns the parts of a body's solids that collide, in the order of the solids. */
    static PlacedSolid[] of(List<Solid> solids, boolean move) {
        List<PlacedSolid> all = new ArrayList<>();
        for (int i = 0; i < solids.size(); i++) {
            if (solids.get(i).isMesh() && !move) {
                all.add(new PlacedSolid(solids.get(i), i, null));
            } else {
                for (ConvexShape piece : solids.get(i).pieces()) {
                    all.add(new PlacedSolid(solids.get(i), i, piece));
                }
            }
        }
        return all.toArray(new PlacedSolid[0]);
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
        double x = Math.abs(place.m00) * half[0] + Math.abs(place.m01) * half[1] + Math.abs(place.m02) * half[2];
        double y = Math.abs(place.m10) * half[0] + Math.abs(place.m11) * half[1] + Math.abs(place.m12) * half[2];
        double z = Math.abs(place.m20) * half[0] + Math.abs(place.m21) * half[1] + Math.abs(place.m22) * half[2];
        place.transform(middle[0], middle[1], middle[2], low, 0);
        box.set(0, low[0] - x, low[0] + x).set(1, low[1] - y, low[1] + y).set(2, low[2] - z, low[2] + z);
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
