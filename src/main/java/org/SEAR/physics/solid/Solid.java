// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.util.List;
import java.util.function.Predicate;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.raycast.BeamScene;

/**
 * Geometry of one object of the grammar, scale included, for rays, collisions, masses, the window and the tab.
 * {@link Solids} lists the shapes.
 */
public abstract class Solid {
    /** Half extents along x, y and z, metres. */
    public final double halfX;
    public final double halfY;
    public final double halfZ;
    /** Pose of the solid's frame in the object's frame. */
    public final Pose offset;
    private Surface surface = Surface.usual();
    private ConvexShape convex;

    /** @param halfX half extent along x, metres, likewise halfY and halfZ */
    protected Solid(double halfX, double halfY, double halfZ, Pose offset) {
        this.halfX = halfX;
        this.halfY = halfY;
        this.halfZ = halfZ;
        this.offset = offset;
    }

    /**
     * Adds the solid to a ray scene.
     * @return its number there
     */
    public abstract int addTo(BeamScene scene, int owner);

    /** Makes the collision shape, with volume, centre of mass and inertia; called once. */
    protected abstract ConvexShape makeConvex();

    /** Returns the drawn mesh in the solid's frame, of a model without its file's materials; null for a terrain. */
    public abstract SurfaceMesh look();

    /** Returns surface points that suffice for its outline from any side: {x, y, z} in the solid's frame, metres. */
    protected abstract double[][] corners();

    /** Returns points that suffice for its outline from any side: {x, y, z} in the object's frame, metres. */
    public final double[][] outline() {
        double[][] points = corners().clone();
        for (int i = 0; i < points.length && offset != Pose.IDENTITY; i++) {
            points[i] = offset.transform(points[i][0], points[i][1], points[i][2]);
        }
        return points;
    }

    /**
     * Returns its areas from above, {x, y, z} of the corners of each in the object's frame, metres; none if the convex
     * hull of its outline shows it.
     */
    public double[][][] areas() {
        return new double[0][][];
    }

    /** Returns a new search for its triangles, for a fixed body. */
    public TriangleSearch triangles() {
        throw new UnsupportedOperationException("only a mesh has triangles");
    }

    /** Returns the collision shape: of a mesh its convex hull. */
    public final ConvexShape convex() {
        if (convex == null) {
            convex = makeConvex();
        }
        return convex;
    }

    /** Returns the convex parts that collide; their order never changes. */
    public List<ConvexShape> pieces() {
        return List.of(convex());
    }

    /** Volume at uniform density, m^3. */
    public double volume() {
        return convex().volume();
    }

    /** Returns one kilogram of the solid at uniform density, in its frame. */
    public MassProperties perKilogram() {
        return MassProperties.of(convex());
    }

    final void setSurface(Surface newSurface) {
        surface = newSurface;
    }

    /** Surface at contacts. */
    public final Surface getSurface() {
        return surface;
    }

    /** Whether it is a triangle mesh by whose triangles fixed bodies collide, not by {@link #pieces}. */
    public boolean isMesh() {
        return false;
    }

    /**
     * Tests triangles of a mesh, at least all that reach into a box, until one passes.
     * @param box in the solid's frame
     * @param test takes x, y and z of the three corners in the solid's frame; the array is valid only during the call
     * @return whether one passed
     */
    public boolean anyTriangle(Aabb box, Predicate<double[]> test) {
        throw new UnsupportedOperationException("only a mesh has triangles");
    }

    /** Smallest extent along its axes, metres. */
    public double thickness() {
        return 2 * Math.min(halfX, Math.min(halfY, halfZ));
    }

    /** Whether a point of its frame is inside its mesh; false without a closed mesh. */
    public boolean encloses(double x, double y, double z) {
        return false;
    }

    /** Returns the furthest point in a direction, both in the solid's frame: {x, y, z}. */
    public double[] farthest(double dx, double dy, double dz) {
        double[] point = new double[3];
        convex().support(dx, dy, dz, point);
        return point;
    }
}
