// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import org.SEAR.geometry.InertiaTensor;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.geometry.Triangles;

/** Cylinder or cone scaled to elliptic ends: rays and bodies hit polygons of {@link #CORNERS} corners. */
final class EllipticSolid extends MeshSolid {
    /** Corners of the polygon that approximates an ellipse. */
    private static final int CORNERS = 64;

    private final boolean cone;

    /**
     * @param radius before scaling, metres
     * @param scale along x, y and z
     */
    EllipticSolid(boolean cone, double radius, double halfHeight, double[] scale, Pose offset) {
        super(triangles(radius, halfHeight, cone), scale, offset);
        this.cone = cone;
    }

    private static Triangles triangles(double radius, double halfHeight, boolean cone) {
        float[] vertices = new float[(2 * CORNERS + 2) * 3];
        int[] indices = new int[CORNERS * 12];
        put(vertices, 2 * CORNERS, 0, -halfHeight, 0);
        put(vertices, 2 * CORNERS + 1, 0, halfHeight, 0);
        for (int i = 0; i < CORNERS; i++) {
            double angle = 2 * Math.PI * i / CORNERS;
            double top = cone ? 0 : radius;
            put(vertices, 2 * i, radius * Math.sin(angle), -halfHeight, radius * Math.cos(angle));
            put(vertices, 2 * i + 1, top * Math.sin(angle), halfHeight, top * Math.cos(angle));
            int next = (i + 1) % CORNERS;
            int[] four = {2 * i, 2 * next, 2 * next + 1, 2 * i, 2 * next + 1, 2 * i + 1,
                2 * CORNERS, 2 * next, 2 * i, 2 * CORNERS + 1, 2 * i + 1, 2 * next + 1};
            System.arraycopy(four, 0, indices, i * 12, 12);
        }
        return new Triangles(vertices, indices);
    }

    private static void put(float[] vertices, int vertex, double x, double y, double z) {
        vertices[vertex * 3] = (float) x;
        vertices[vertex * 3 + 1] = (float) y;
        vertices[vertex * 3 + 2] = (float) z;
    }

    @Override
    public double volume() {
        return 2 * Math.PI * halfX * halfY * halfZ / (cone ? 3 : 1);
    }

    /** Returns the exact elliptic solid. */
    @Override
    public MassProperties perKilogram() {
        double ring = cone ? 0.15 : 0.25;
        double along = cone ? 0.15 * halfY * halfY : halfY * halfY / 3;
        InertiaTensor inertia = new InertiaTensor(ring * halfZ * halfZ + along, ring * (halfX * halfX + halfZ * halfZ),
            ring * halfX * halfX + along);
        return new MassProperties(1, new double[] {0, cone ? -halfY / 2 : 0, 0}, inertia);
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
