package org.SEAR.raycast;

import java.util.Map;
import java.util.WeakHashMap;
import org.SEAR.geometry.Triangles;

/**
 * Triangles in the order of their hierarchy, in the model's own unscaled frame: 36 bytes a triangle for the corners and about as many for the
 * nodes. Immutable, any thread. The same {@link Triangles} share one mesh as long as somebody holds them.
 */
final class Mesh {
    private static final int LEAF_SIZE = 4;
    /** Squared sine below which a triangle is seen edge-on and, having no thickness, not met. */
    private static final double EDGE_ON = 1e-24;
    private static final Map<Triangles, Mesh> KNOWN = new WeakHashMap<>();

    final Bvh tree;
    /** Nine floats a triangle, in the order of the tree: x, y, z of its three corners. */
    final float[] corners;

    /** Bounds are rounded outward: the slab test leaves out a beam that runs within a box's side, so none may. */
    private Mesh(Triangles triangles) {
        int n = triangles.size();
        float[] boxes = new float[n * Bvh.BOUNDS];
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < 3; k++) {
                float a = triangles.vertices[3 * triangles.indices[3 * i] + k];
                float b = triangles.vertices[3 * triangles.indices[3 * i + 1] + k];
                float c = triangles.vertices[3 * triangles.indices[3 * i + 2] + k];
                boxes[i * Bvh.BOUNDS + k] = Math.nextDown(Math.min(a, Math.min(b, c)));
                boxes[i * Bvh.BOUNDS + k + 3] = Math.nextUp(Math.max(a, Math.max(b, c)));
            }
        }
        Bvh built = BvhBuilder.build(boxes, LEAF_SIZE);
        corners = new float[9 * n];
        for (int i = 0; i < n; i++) {
            for (int corner = 0; corner < 3; corner++) {
                int vertex = triangles.indices[3 * built.items[i] + corner];
                System.arraycopy(triangles.vertices, 3 * vertex, corners, 9 * i + 3 * corner, 3);
            }
        }
        tree = new Bvh(built.data, new int[0]);
    }

    /** The mesh of these triangles, built when it is asked for the first time. */
    static Mesh of(Triangles triangles) {
        synchronized (KNOWN) {
            return KNOWN.computeIfAbsent(triangles, Mesh::new);
        }
    }

    /**
     * Where a beam meets one triangle, from either side. Each edge is judged by the same numbers in both triangles that share it, so no beam slips
     * through between them.
     */
    static double triangle(float[] v, int at, double ox, double oy, double oz, double dx, double dy, double dz) {
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

    /** Writes the normal of a triangle, counter-clockwise corners in front, of any length. */
    void normal(int triangle, double[] out) {
        int at = 9 * triangle;
        double ux = (double) corners[at + 3] - corners[at];
        double uy = (double) corners[at + 4] - corners[at + 1];
        double uz = (double) corners[at + 5] - corners[at + 2];
        double wx = (double) corners[at + 6] - corners[at];
        double wy = (double) corners[at + 7] - corners[at + 1];
        double wz = (double) corners[at + 8] - corners[at + 2];
        out[0] = uy * wz - uz * wy;
        out[1] = uz * wx - ux * wz;
        out[2] = ux * wy - uy * wx;
    }
}
