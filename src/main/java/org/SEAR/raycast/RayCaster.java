package org.SEAR.raycast;

/** Casts single beams; holds what one thread needs for it, so that casting allocates nothing. */
final class RayCaster {
    /** Stands for 1 / 0, so that 0 * INFINITE is 0. */
    private static final double INFINITE = 1e300;
    /** A node's far side is moved out by this factor: more than the rounding of the slab test. */
    private static final double ROUNDING = 1 + 1e-13;

    /** Work done since the thread's first cast: nodes of hierarchies, shapes and triangles looked at. */
    long nodes;
    long tested;
    long triangles;

    private final int[] stack = new int[Tree.MAX_DEPTH];
    private final double[] stackNear = new double[Tree.MAX_DEPTH];
    private final int[] meshStack = new int[Tree.MAX_DEPTH];
    private final double[] meshStackNear = new double[Tree.MAX_DEPTH];
    private final double[] point = new double[3];
    /** The triangle that the last successful {@link #mesh} met. */
    private int triangle;

    /** Nearest distance of a beam over all shapes that the owner sees; the lower shape number wins a tie. */
    double cast(Shapes shapes, Tree tree, double ox, double oy, double oz, double dx, double dy, double dz, double maxRange, int ignored, Hit hit) {
        double best = Double.POSITIVE_INFINITY;
        int found = -1;
        double limit = maxRange;
        double ix = inverse(dx);
        double iy = inverse(dy);
        double iz = inverse(dz);
        int nearX = ix >= 0 ? 0 : 3;
        int nearY = iy >= 0 ? 1 : 4;
        int nearZ = iz >= 0 ? 2 : 5;
        float[] box = tree.data;
        int depth = 0;
        int node = tree.size() > 0 && near(box, 0, nearX, nearY, nearZ, ox, oy, oz, ix, iy, iz, limit) >= 0 ? 0 : -1;
        while (node >= 0) {
            nodes++;
            int n = tree.count(node);
            if (n == 0) {
                int left = tree.link(node);
                int right = left + 1;
                double nearLeft = near(box, left * Tree.STRIDE, nearX, nearY, nearZ, ox, oy, oz, ix, iy, iz, limit);
                double nearRight = near(box, right * Tree.STRIDE, nearX, nearY, nearZ, ox, oy, oz, ix, iy, iz, limit);
                if (nearLeft >= 0 && nearRight >= 0) {
                    boolean leftFirst = nearLeft <= nearRight;
                    stack[depth] = leftFirst ? right : left;
                    stackNear[depth++] = leftFirst ? nearRight : nearLeft;
                    node = leftFirst ? left : right;
                    continue;
                } else if (nearLeft >= 0 || nearRight >= 0) {
                    node = nearLeft >= 0 ? left : right;
                    continue;
                }
            } else {
                int first = tree.link(node);
                for (int i = first; i < first + n; i++) {
                    int shape = tree.items[i];
                    if (shapes.isSeen(shape, ignored)) {
                        double t = test(shapes, shape, ox, oy, oz, dx, dy, dz, limit);
                        if (t < best && t <= maxRange || t == best && shape < found) {
                            best = t;
                            limit = t;
                            found = shape;
                        }
                    }
                }
            }
            node = -1;
            while (depth > 0 && node < 0) {
                depth--;
                node = stackNear[depth] <= limit ? stack[depth] : -1;
            }
        }
        if (hit != null && found >= 0) {
            describe(shapes, found, ox, oy, oz, dx, dy, dz, best, hit);
        }
        return best;
    }

    private static double inverse(double d) {
        return d == 0 ? INFINITE : 1 / d;
    }

    /** Where the beam enters a node, 0 from inside, -1 when it misses or comes too late. */
    private static double near(float[] box, int at, int nearX, int nearY, int nearZ, double ox, double oy, double oz, double ix, double iy,
        double iz, double limit) {
        double x = (box[at + nearX] - ox) * ix;
        double y = (box[at + nearY] - oy) * iy;
        double z = (box[at + nearZ] - oz) * iz;
        double in = Math.max(Math.max(x, y), Math.max(z, 0));
        x = (box[at + 3 - nearX] - ox) * ix;
        y = (box[at + 5 - nearY] - oy) * iy;
        z = (box[at + 7 - nearZ] - oz) * iz;
        double out = Math.min(Math.min(x, y), z);
        return in <= out * ROUNDING && in <= limit * ROUNDING ? in : -1;
    }

    /** Distance to one shape alone. */
    double test(Shapes shapes, int shape, double ox, double oy, double oz, double dx, double dy, double dz, double limit) {
        tested++;
        double[] m = shapes.data;
        int i = shape * Shapes.STRIDE;
        double wx = ox - m[i + 9];
        double wy = oy - m[i + 10];
        double wz = oz - m[i + 11];
        double px = m[i] * wx + m[i + 3] * wy + m[i + 6] * wz;
        double py = m[i + 1] * wx + m[i + 4] * wy + m[i + 7] * wz;
        double pz = m[i + 2] * wx + m[i + 5] * wy + m[i + 8] * wz;
        double vx = m[i] * dx + m[i + 3] * dy + m[i + 6] * dz;
        double vy = m[i + 1] * dx + m[i + 4] * dy + m[i + 7] * dz;
        double vz = m[i + 2] * dx + m[i + 5] * dy + m[i + 8] * dz;
        double a = m[i + 12];
        double b = m[i + 13];
        double c = m[i + 14];
        switch (shapes.kind[shape]) {
            case Shapes.BOX:
                return Solids.box(px, py, pz, vx, vy, vz, a, b, c);
            case Shapes.ROUND:
                return Solids.round(px, py, pz, vx, vy, vz, a, b, c);
            default:
                return mesh(shapes.mesh[shape], px / a, py / b, pz / c, vx / a, vy / b, vz / c, limit);
        }
    }

    private double mesh(Mesh mesh, double ox, double oy, double oz, double dx, double dy, double dz, double maxRange) {
        Tree tree = mesh.tree;
        float[] box = tree.data;
        double best = Double.POSITIVE_INFINITY;
        double limit = maxRange;
        double ix = inverse(dx);
        double iy = inverse(dy);
        double iz = inverse(dz);
        int nearX = ix >= 0 ? 0 : 3;
        int nearY = iy >= 0 ? 1 : 4;
        int nearZ = iz >= 0 ? 2 : 5;
        int depth = 0;
        int node = tree.size() > 0 && near(box, 0, nearX, nearY, nearZ, ox, oy, oz, ix, iy, iz, limit) >= 0 ? 0 : -1;
        while (node >= 0) {
            nodes++;
            int n = tree.count(node);
            if (n == 0) {
                int left = tree.link(node);
                int right = left + 1;
                double nearLeft = near(box, left * Tree.STRIDE, nearX, nearY, nearZ, ox, oy, oz, ix, iy, iz, limit);
                double nearRight = near(box, right * Tree.STRIDE, nearX, nearY, nearZ, ox, oy, oz, ix, iy, iz, limit);
                if (nearLeft >= 0 && nearRight >= 0) {
                    boolean leftFirst = nearLeft <= nearRight;
                    meshStack[depth] = leftFirst ? right : left;
                    meshStackNear[depth++] = leftFirst ? nearRight : nearLeft;
                    node = leftFirst ? left : right;
                    continue;
                } else if (nearLeft >= 0 || nearRight >= 0) {
                    node = nearLeft >= 0 ? left : right;
                    continue;
                }
            } else {
                int first = tree.link(node);
                triangles += n;
                for (int i = first; i < first + n; i++) {
                    double t = Mesh.triangle(mesh.corners, 9 * i, ox, oy, oz, dx, dy, dz);
                    if (t <= limit && (t < best || t == best && i < triangle)) {
                        best = t;
                        limit = t;
                        triangle = i;
                    }
                }
            }
            node = -1;
            while (depth > 0 && node < 0) {
                depth--;
                node = meshStackNear[depth] <= limit ? meshStack[depth] : -1;
            }
        }
        return best;
    }

    private void describe(Shapes shapes, int shape, double ox, double oy, double oz, double dx, double dy, double dz, double t, Hit hit) {
        hit.shape = shape;
        hit.distance = t;
        double[] m = shapes.data;
        int i = shape * Shapes.STRIDE;
        double a = m[i + 12];
        double b = m[i + 13];
        double c = m[i + 14];
        if (shapes.kind[shape] == Shapes.MESH) {
            test(shapes, shape, ox, oy, oz, dx, dy, dz, t);
            shapes.mesh[shape].normal(triangle, point);
            point[0] /= a;
            point[1] /= b;
            point[2] /= c;
        } else {
            double wx = ox + t * dx - m[i + 9];
            double wy = oy + t * dy - m[i + 10];
            double wz = oz + t * dz - m[i + 11];
            point[0] = m[i] * wx + m[i + 3] * wy + m[i + 6] * wz;
            point[1] = m[i + 1] * wx + m[i + 4] * wy + m[i + 7] * wz;
            point[2] = m[i + 2] * wx + m[i + 5] * wy + m[i + 8] * wz;
            if (shapes.kind[shape] == Shapes.BOX) {
                Solids.boxNormal(point, a, b, c);
            } else {
                Solids.roundNormal(point, a, b, c);
            }
        }
        double nx = m[i] * point[0] + m[i + 1] * point[1] + m[i + 2] * point[2];
        double ny = m[i + 3] * point[0] + m[i + 4] * point[1] + m[i + 5] * point[2];
        double nz = m[i + 6] * point[0] + m[i + 7] * point[1] + m[i + 8] * point[2];
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        hit.nx = nx / length;
        hit.ny = ny / length;
        hit.nz = nz / length;
    }
}
