package org.SEAR.physics.solid;

import java.util.function.Predicate;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.raycast.BeamScene;

/**
 * The geometry of one object of the grammar, scale included: what beams, collisions, masses, the window and the tab ask of a shape. {@link Solids}
 * lists the shapes that there are.
 */
public abstract class Solid {
    /** Half sizes along x, y and z. */
    public final double halfX;
    public final double halfY;
    public final double halfZ;
    /** Where the solid's own frame stands in the object's frame. */
    public final Pose offset;
    private Surface surface = Surface.usual();
    private ConvexShape convex;

    /** @param halfX half size along x, metres, likewise halfY and halfZ */
    protected Solid(double halfX, double halfY, double halfZ, Pose offset) {
        this.halfX = halfX;
        this.halfY = halfY;
        this.halfZ = halfZ;
        this.offset = offset;
    }

    /**
     * Adds it to what beams meet.
     *
     * @return its number there
     */
    public abstract int addTo(BeamScene scene, int owner);

    /** What of it collides, with its volume, centre of mass and inertia; made once. */
    protected abstract ConvexShape makeConvex();

    /** What it looks like, in its own frame: of a model its triangles, without the look that its file has; null for a terrain. */
    public abstract SurfaceMesh look();

    /** Points of its surface that are enough to draw its outline from any side: {x, y, z} in its own frame, metres. */
    protected abstract double[][] corners();

    /** Points that are enough to draw its outline from any side: {x, y, z} in the object's frame, metres. */
    public final double[][] outline() {
        double[][] points = corners().clone();
        for (int i = 0; i < points.length && offset != Pose.IDENTITY; i++) {
            points[i] = offset.transform(points[i][0], points[i][1], points[i][2]);
        }
        return points;
    }

    /** A new search for its triangles, for a body that never moves. */
    public TriangleSearch triangles() {
        throw new UnsupportedOperationException("only a mesh has triangles");
    }

    /** What of it collides: a mesh that moves counts as its convex hull. */
    public final ConvexShape convex() {
        if (convex == null) {
            convex = makeConvex();
        }
        return convex;
    }

    final void setSurface(Surface newSurface) {
        surface = newSurface;
    }

    /** What it does where it touches. */
    public final Surface getSurface() {
        return surface;
    }

    /** Whether it is triangles: what does not move then collides by them, not by the convex hull. */
    public boolean isMesh() {
        return false;
    }

    /**
     * Tries the triangles of a mesh, at least those that reach into a box, until one passes.
     *
     * @param box in its own frame
     * @param test takes x, y and z of the three corners in its own frame, only while it is called
     * @return whether one passed
     */
    public boolean anyTriangle(Aabb box, Predicate<double[]> test) {
        throw new UnsupportedOperationException("only a mesh has triangles");
    }

    /** The farthest point in a direction of its own frame: {x, y, z}. */
    public double[] farthest(double dx, double dy, double dz) {
        double[] point = new double[3];
        convex().support(dx, dy, dz, point);
        return point;
    }
}
