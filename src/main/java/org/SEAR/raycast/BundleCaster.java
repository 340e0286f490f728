// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import org.SEAR.raycast.tree.Bvh;

/**
 * Finds the shortest ray of a narrow bundle from one point, such as a sonar's. Walks the hierarchy once for all rays,
 * nearest boxes first (branch and bound). Skips boxes beyond the shortest ray so far or outside the bundle's cone. One
 * thread.
 */
final class BundleCaster {
    /** Relative tolerance, above the rounding errors of node bounds and their tests. */
    private static final double SLACK = 1e-9;

    private final RayCaster rays;
    private final int[] stack = new int[Bvh.MAX_DEPTH];
    private final double[] stackNear = new double[Bvh.MAX_DEPTH];
    private double axisX;
    private double axisY;
    private double axisZ;
    private double cosine;
    private double sine;
    private double best;
    private int line;

    BundleCaster(RayCaster rays) {
        this.rays = rays;
    }

    /**
     * Returns the length of the shortest ray, infinite if none hits anything within its range.
     * @param directions unit vectors, x, y and z of each ray
     * @param ranges maximum distance of each ray, metres
     */
    double cast(Shapes shapes, Bvh tree, double ox, double oy, double oz, double[] directions, double[] ranges,
        int ignored) {
        best = Double.POSITIVE_INFINITY;
        line = -1;
        enclose(directions, ranges.length);
        double limit = 0;
        for (double range : ranges) {
            limit = Math.max(limit, range);
        }
        int depth = 0;
        if (tree.size() > 0) {
            stack[depth++] = 0;
            stackNear[0] = distance(tree.data, 0, ox, oy, oz);
        }
        while (depth > 0) {
            depth--;
            double reach = Math.min(best, limit) * (1 + SLACK);
            if (stackNear[depth] > reach * reach) {
                continue;
            }
            int node = stack[depth];
            int count = tree.count(node);
            if (count > 0) {
                for (int i = tree.link(node); i < tree.link(node) + count; i++) {
                    if (shapes.isSeen(tree.items[i], ignored)) {
                        test(shapes, tree.items[i], tree.data, node * Bvh.STRIDE, ox, oy, oz, directions, ranges);
                    }
                }
                continue;
            }
            int left = tree.link(node);
            double nearLeft = isBeside(tree.data, left * Bvh.STRIDE, ox, oy, oz) ? -1
                : distance(tree.data, left * Bvh.STRIDE, ox, oy, oz);
            double nearRight = isBeside(tree.data, (left + 1) * Bvh.STRIDE, ox, oy, oz) ? -1
                : distance(tree.data, (left + 1) * Bvh.STRIDE, ox, oy, oz);
            boolean leftLast = nearLeft >= nearRight;
            depth = push(depth, leftLast ? left : left + 1, leftLast ? nearLeft : nearRight);
            depth = push(depth, leftLast ? left + 1 : left, leftLast ? nearRight : nearLeft);
        }
        return best;
    }

    /** Returns the number of the shortest ray of the last cast, the first of equals, or -1 without a hit. */
    int getLine() {
        return line;
    }

    private int push(int depth, int node, double near) {
        if (near < 0) {
            return depth;
        }
        stack[depth] = node;
        stackNear[depth] = near;
        return depth + 1;
    }

    /** Computes the cone around all rays. */
    private void enclose(double[] directions, int count) {
        axisX = 0;
        axisY = 0;
        axisZ = 0;
        for (int i = 0; i < count; i++) {
            axisX += directions[3 * i];
            axisY += directions[3 * i + 1];
            axisZ += directions[3 * i + 2];
        }
        double length = Math.sqrt(axisX * axisX + axisY * axisY + axisZ * axisZ);
        cosine = length > 0 ? 1 : -1;
        for (int i = 0; i < count && length > 0; i++) {
            double along = (axisX * directions[3 * i] + axisY * directions[3 * i + 1]
                + axisZ * directions[3 * i + 2]) / length;
            cosine = Math.min(cosine, along);
        }
        cosine -= SLACK;
        sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
        axisX /= Math.max(length, Double.MIN_NORMAL);
        axisY /= Math.max(length, Double.MIN_NORMAL);
        axisZ /= Math.max(length, Double.MIN_NORMAL);
    }

    /**
     * Returns whether the sphere around a node's bounds is outside the cone. Always false for cones of a half-space or
     * more.
     */
    private boolean isBeside(float[] box, int at, double ox, double oy, double oz) {
        if (cosine <= 0) {
            return false;
        }
        double x = ((double) box[at] + box[at + 3]) / 2 - ox;
        double y = ((double) box[at + 1] + box[at + 4]) / 2 - oy;
        double z = ((double) box[at + 2] + box[at + 5]) / 2 - oz;
        double radius = radius(box, at);
        double along = axisX * x + axisY * y + axisZ * z;
        double across = Math.sqrt(Math.max(0, x * x + y * y + z * z - along * along));
        return across * cosine - along * sine > radius;
    }

    private static double radius(float[] box, int at) {
        double x = (double) box[at + 3] - box[at];
        double y = (double) box[at + 4] - box[at + 1];
        double z = (double) box[at + 5] - box[at + 2];
        return Math.sqrt(x * x + y * y + z * z) / 2 * (1 + SLACK) + SLACK;
    }

    /** Returns the squared distance to a node's bounds, m^2. */
    private static double distance(float[] box, int at, double ox, double oy, double oz) {
        double x = Math.max(0, Math.max(box[at] - ox, ox - box[at + 3]));
        double y = Math.max(0, Math.max(box[at + 1] - oy, oy - box[at + 4]));
        double z = Math.max(0, Math.max(box[at + 2] - oz, oz - box[at + 5]));
        return x * x + y * y + z * z;
    }

    /** Tests all rays against one shape, except rays that miss the sphere around its bounds. */
    private void test(Shapes shapes, int shape, float[] box, int at, double ox, double oy, double oz,
        double[] directions, double[] ranges) {
        double x = ((double) box[at] + box[at + 3]) / 2 - ox;
        double y = ((double) box[at + 1] + box[at + 4]) / 2 - oy;
        double z = ((double) box[at + 2] + box[at + 5]) / 2 - oz;
        double radius = radius(box, at);
        double squared = x * x + y * y + z * z;
        boolean inside = squared <= radius * radius;
        double least = Math.sqrt(Math.max(0, squared - radius * radius)) * (1 - SLACK);
        for (int i = 0; i < ranges.length; i++) {
            double dx = directions[3 * i];
            double dy = directions[3 * i + 1];
            double dz = directions[3 * i + 2];
            if (!inside && x * dx + y * dy + z * dz < least) {
                continue;
            }
            double limit = Math.min(best, ranges[i]);
            double t = rays.test(shapes, shape, ox, oy, oz, dx, dy, dz, limit);
            if (t <= ranges[i] && (t < best || t == best && i < line)) {
                best = t;
                line = i;
            }
        }
    }
}
