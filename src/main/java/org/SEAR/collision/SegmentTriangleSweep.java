// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import javax.vecmath.Vector3f;

/**
 * Continuous collision detection with a mesh: where the path of a body's centre in a substep first passes through a
 * triangle. A segment intersects a triangle where no barycentric coordinate is negative (Moeller and Trumbore, "Fast,
 * minimum storage ray/triangle intersection", 1997). Simulation thread.
 */
public final class SegmentTriangleSweep {
    private static final double PARALLEL = 1e-15;
    /** Tolerance of barycentric coordinates, so that no path passes between two triangles. */
    private static final double EDGE = 1e-9;

    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;
    private double share;
    private final double[] normal = new double[3];

    /**
     * Begins a new segment.
     * @param from {x, y, z} in the mesh's frame, metres
     * @param to likewise
     */
    public void begin(double[] from, double[] to) {
        ox = from[0];
        oy = from[1];
        oz = from[2];
        dx = to[0] - ox;
        dy = to[1] - oy;
        dz = to[2] - oz;
        share = 1;
    }

    /** Tests a triangle, in the mesh's frame. */
    public void look(Vector3f[] corners) {
        double ux = (double) corners[1].x - corners[0].x;
        double uy = (double) corners[1].y - corners[0].y;
        double uz = (double) corners[1].z - corners[0].z;
        double wx = (double) corners[2].x - corners[0].x;
        double wy = (double) corners[2].y - corners[0].y;
        double wz = (double) corners[2].z - corners[0].z;
        double nx = uy * wz - uz * wy;
        double ny = uz * wx - ux * wz;
        double nz = ux * wy - uy * wx;
        double facing = -(dx * nx + dy * ny + dz * nz);
        if (Math.abs(facing) < PARALLEL) {
            return;
        }
        double ax = ox - corners[0].x;
        double ay = oy - corners[0].y;
        double az = oz - corners[0].z;
        double t = (ax * nx + ay * ny + az * nz) / facing;
        double mx = ay * dz - az * dy;
        double my = az * dx - ax * dz;
        double mz = ax * dy - ay * dx;
        double u = (wx * mx + wy * my + wz * mz) / facing;
        double v = -(ux * mx + uy * my + uz * mz) / facing;
        if (t >= 0 && t < share && u >= -EDGE && v >= -EDGE && u + v <= 1 + EDGE) {
            share = t;
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            normal[0] = nx / length;
            normal[1] = ny / length;
            normal[2] = nz / length;
        }
    }

    /** Share of the segment before the first triangle; 1 without intersection. */
    public double getShare() {
        return share;
    }

    /** Normal of that triangle, of either sign, in the mesh's frame; always the same array. */
    public double[] getNormal() {
        return normal;
    }
}
