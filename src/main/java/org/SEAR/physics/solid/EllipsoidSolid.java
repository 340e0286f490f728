// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import org.SEAR.POJOs.Sphere;
import org.SEAR.collision.ConvexEllipsoid;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.solid.RayEllipsoid;

/** Sphere or ellipsoid. */
final class EllipsoidSolid extends Solid {
    /** Mesh for the window: sides per circle of latitude, and strips between the poles. */
    private static final int SIDES = 32;
    private static final int STRIPS = 16;
    /** Points of the outline in the tab. */
    private static final int POINTS = 128;
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    private EllipsoidSolid(double halfX, double halfY, double halfZ) {
        super(halfX, halfY, halfZ, Pose.IDENTITY);
    }

    static EllipsoidSolid of(Sphere sphere) {
        double radius = sphere.getRadius();
        return new EllipsoidSolid(radius * sphere.getScaleX(), radius * sphere.getScaleY(),
            radius * sphere.getScaleZ());
    }

    @Override
    public int addTo(BeamScene scene, int owner) {
        return scene.addSolid(new RayEllipsoid(halfX, halfY, halfZ), owner);
    }

    @Override
    protected ConvexShape makeConvex() {
        return new ConvexEllipsoid(halfX, halfY, halfZ);
    }

    /**
     * The picture's left edge is at +z and its lower edge at the lower pole; it runs counter-clockwise seen from above.
     */
    @Override
    public SurfaceMesh look() {
        SurfaceMesh mesh = new SurfaceMesh();
        for (int strip = 0; strip <= STRIPS; strip++) {
            double y = -Math.cos(Math.PI * strip / STRIPS);
            double ring = Math.sin(Math.PI * strip / STRIPS);
            for (int side = 0; side <= SIDES; side++) {
                double x = ring * Math.sin(2 * Math.PI * side / SIDES);
                double z = ring * Math.cos(2 * Math.PI * side / SIDES);
                int upper = mesh.vertex(halfX * x, halfY * y, halfZ * z, x / halfX, y / halfY, z / halfZ,
                    (double) side / SIDES,
                    (double) strip / STRIPS);
                if (strip > 0 && side < SIDES) {
                    int lower = upper - SIDES - 1;
                    mesh.triangle(lower, lower + 1, upper);
                    mesh.triangle(lower + 1, upper + 1, upper);
                }
            }
        }
        return mesh;
    }

    /** Points spread evenly over the sphere. */
    @Override
    protected double[][] corners() {
        double[][] points = new double[POINTS][];
        for (int i = 0; i < POINTS; i++) {
            double y = 1 - 2 * (i + 0.5) / POINTS;
            double ring = Math.sqrt(1 - y * y);
            points[i] = new double[] {halfX * ring * Math.cos(i * GOLDEN_ANGLE), halfY * y,
                halfZ * ring * Math.sin(i * GOLDEN_ANGLE)};
        }
        return points;
    }
}
