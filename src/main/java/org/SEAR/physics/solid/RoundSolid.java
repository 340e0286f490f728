// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Wheel;
import org.SEAR.collision.ConvexRound;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.solid.RayRound;

/** Cylinder or cone about its y axis with circular ends; a wheel is a cylinder on its side. */
public final class RoundSolid extends Solid {
    private static final Pose AXLE_ALONG_X = Pose.ofDegrees(0, 0, 0, 0, 0, 90);

    private final boolean cone;

    private RoundSolid(boolean cone, double radius, double halfHeight, Pose offset) {
        super(radius, halfHeight, radius, offset);
        this.cone = cone;
    }

    static Solid of(Cylinder shape) {
        return of(false, shape.getRadius(), shape.getHeight() / 2, shape.getScaleX(), shape.getScaleY(),
            shape.getScaleZ(), Pose.IDENTITY);
    }

    static Solid of(Cone shape) {
        return of(true, shape.getRadius(), shape.getHeight() / 2, shape.getScaleX(), shape.getScaleY(),
            shape.getScaleZ(), Pose.IDENTITY);
    }

    static Solid of(Wheel shape) {
        return of(false, shape.getRadius(), shape.getWidth() / 2, shape.getScaleY(), shape.getScaleX(),
            shape.getScaleZ(), AXLE_ALONG_X);
    }

    private static Solid of(boolean cone, double radius, double halfHeight, double sx, double sy, double sz,
        Pose offset) {
        return sx == sz ? new RoundSolid(cone, radius * sx, halfHeight * sy, offset)
            : new EllipticSolid(cone, radius, halfHeight, new double[] {sx, sy, sz}, offset);
    }

    /**
     * Returns a cylinder with its axle along x.
     * @param radius metres
     */
    public static RoundSolid wheel(double radius, double halfWidth) {
        return new RoundSolid(false, radius, halfWidth, AXLE_ALONG_X);
    }

    @Override
    public int addTo(BeamScene scene, int owner) {
        return scene.addSolid(cone ? RayRound.cone(halfX, halfY) : RayRound.cylinder(halfX, halfY), owner);
    }

    @Override
    protected ConvexShape makeConvex() {
        return cone ? ConvexRound.cone(halfX, halfY) : ConvexRound.cylinder(halfX, halfY);
    }

    @Override
    public SurfaceMesh look() {
        return RoundPictureMap.of(halfX, halfY, halfZ, cone);
    }

    @Override
    protected double[][] corners() {
        return RoundPictureMap.rims(halfX, halfY, halfZ, cone);
    }
}
