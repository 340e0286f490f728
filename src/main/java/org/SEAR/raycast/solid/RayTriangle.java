// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

/** Intersection of a ray with one triangle of a mesh or height field. */
public final class RayTriangle {
    /** Squared sine below which a ray sees a triangle edge-on and misses it: triangles have no thickness. */
    private static final double EDGE_ON = 1e-24;

    private RayTriangle() {
    }

    /**
     * Returns the distance to the triangle, from either side. Both triangles of a shared edge use the same edge values,
     * so no ray slips through between them.
     * @param v x, y and z of the corners, nine numbers from {@code at} on
     * @return the distance as defined by {@link RaySolid}
     */
    public static double intersect(float[] v, int at, double ox, double oy, double oz, double dx, double dy,
        double dz) {
        double ax = v[at] - ox;
        double ay = v[at + 1] - oy;
        double az = v[at + 2] - oz;
        double bx = v[at + 3] - ox;
        double by = v[at + 4] - oy;
        double bz = v[at + 5] - oz;
        double cx = v[at + 6] - ox;
        double cy = v[at + 7] - oy;
        double cz = v[at + 8] - oz;
        double ab = dx * (ay * bz - az * by) + dy * (az * bx - ax * bz) + dz * (ax * by - ay * bx);
        double bc = dx * (by * cz - bz * cy) + dy * (bz * cx - bx * cz) + dz * (bx * cy - by * cx);
        if (ab < 0 && bc > 0 || ab > 0 && bc < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double ca = dx * (cy * az - cz * ay) + dy * (cz * ax - cx * az) + dz * (cx * ay - cy * ax);
        if ((ab < 0 || bc < 0) && ca > 0 || (ab > 0 || bc > 0) && ca < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double ux = bx - ax;
        double uy = by - ay;
        double uz = bz - az;
        double wx = cx - ax;
        double wy = cy - ay;
        double wz = cz - az;
        double nx = uy * wz - uz * wy;
        double ny = uz * wx - ux * wz;
        double nz = ux * wy - uy * wx;
        double slope = nx * dx + ny * dy + nz * dz;
        if (slope * slope <= EDGE_ON * (nx * nx + ny * ny + nz * nz) * (dx * dx + dy * dy + dz * dz)) {
            return Double.POSITIVE_INFINITY;
        }
        double t = (nx * ax + ny * ay + nz * az) / slope;
        return t >= 0 ? t : Double.POSITIVE_INFINITY;
    }

    /** Writes the normal, of any length. It points to the side that sees the corners counter-clockwise. */
    public static void normal(float[] v, int at, double[] out) {
        double ux = (double) v[at + 3] - v[at];
        double uy = (double) v[at + 4] - v[at + 1];
        double uz = (double) v[at + 5] - v[at + 2];
        double wx = (double) v[at + 6] - v[at];
        double wy = (double) v[at + 7] - v[at + 1];
        double wz = (double) v[at + 8] - v[at + 2];
        out[0] = uy * wz - uz * wy;
        out[1] = uz * wx - ux * wz;
        out[2] = ux * wy - uy * wx;
    }
}
