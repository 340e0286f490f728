package org.SEAR.physics;

import com.bulletphysics.collision.shapes.CollisionShape;
import org.SEAR.collision.ContactFeature;
import org.SEAR.collision.Convex;
import org.SEAR.collision.PlacedConvex;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Placement;
import org.SEAR.physics.solid.Solid;

/** A solid of a body where it stands now, with the box around it. Simulation thread. */
final class PlacedSolid implements Convex {
    final Solid solid;
    final Placement place;
    private final PlacedConvex convex = new PlacedConvex();
    private final CollisionShape shape;
    private final boolean mesh;
    /** World frame. */
    final Aabb box = new Aabb();
    private final double[] low = new double[3];
    private final double[] high = new double[3];

    /** @param shape jbullet's, which finds a mesh's triangles */
    PlacedSolid(Solid solid, CollisionShape shape, boolean moves) {
        this.solid = solid;
        this.shape = shape;
        mesh = solid.isMesh() && !moves;
        place = mesh ? new Placement() : convex.set(solid.convex());
    }

    /** Whether its triangles collide. */
    boolean isMesh() {
        return mesh;
    }

    CollisionShape getShape() {
        return shape;
    }

    @Override
    public void support(double dx, double dy, double dz, double[] into) {
        convex.support(dx, dy, dz, into);
    }

    /** What is inside its skin. */
    Convex core() {
        return convex.core();
    }

    /** The part of it that faces a direction, in the world. */
    void feature(double dx, double dy, double dz, ContactFeature into) {
        convex.feature(dx, dy, dz, into);
    }

    /** Draws the box anew when the place has changed. */
    void bound() {
        for (int axis = 0; axis < 3; axis++) {
            double x = axis == 0 ? place.m00 : axis == 1 ? place.m10 : place.m20;
            double y = axis == 0 ? place.m01 : axis == 1 ? place.m11 : place.m21;
            double z = axis == 0 ? place.m02 : axis == 1 ? place.m12 : place.m22;
            double at = axis == 0 ? place.x : axis == 1 ? place.y : place.z;
            double half = Math.abs(x) * solid.halfX + Math.abs(y) * solid.halfY + Math.abs(z) * solid.halfZ;
            box.set(axis, at - half, at + half);
        }
    }

    boolean isNear(PlacedSolid other, double margin) {
        return box.overlaps(other.box, margin);
    }

    /**
     * The box around another solid in this one's frame.
     *
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
