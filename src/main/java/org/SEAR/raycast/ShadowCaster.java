// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import org.SEAR.raycast.tree.Bvh;

/**
 * Determines whether points are in the shadow of an infinitely distant light, by parallel rays from points close
 * together. Walks the hierarchy once for the box that contains all rays. One thread; allocates nothing.
 */
final class ShadowCaster {
    /**
     * Offset of a ray's start from its own surface, relative to the point's distance from the world's origin and in
     * metres.
     */
    private static final double OFF = 1e-7;
    private static final double SLACK = 1e-9;
    private static final double LARGEST = 1e30;

    private final RayCaster rays;
    private final int[] stack = new int[Bvh.MAX_DEPTH];
    /** Axes of the bounding box: two across the light, then the direction to the light. */
    private final double[] axes = new double[9];
    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private double[] points;
    private int[] own;
    private byte[] lit;
    private int count;

    ShadowCaster(RayCaster rays) {
        this.rays = rays;
    }

    /** Sets the unit direction to the light. */
    void begin(double lx, double ly, double lz) {
        boolean steep = Math.abs(ly) > 0.5;
        double ux = steep ? 0 : lz;
        double uy = steep ? -lz : 0;
        double uz = steep ? ly : -lx;
        double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
        axes[0] = ux / length;
        axes[1] = uy / length;
        axes[2] = uz / length;
        axes[3] = ly * axes[2] - lz * axes[1];
        axes[4] = lz * axes[0] - lx * axes[2];
        axes[5] = lx * axes[1] - ly * axes[0];
        axes[6] = lx;
        axes[7] = ly;
        axes[8] = lz;
    }

    /** See {@link BeamScene#castShadows}. */
    void cast(Shapes shapes, Bvh tree, boolean[] casting, double[] pointsAsked, int[] shapesOfPoints, byte[] litPoints,
        int number) {
        points = pointsAsked;
        own = shapesOfPoints;
        lit = litPoints;
        count = number;
        if (tree.size() == 0 || !enclose()) {
            return;
        }
        int open = 1;
        stack[0] = 0;
        while (open > 0) {
            int node = stack[--open];
            if (!intersects(tree.data, node * Bvh.STRIDE)) {
                continue;
            }
            int link = tree.link(node);
            int items = tree.count(node);
            for (int i = link; i < link + items; i++) {
                int shape = tree.items[i];
                if (casting[shape] && shapes.visible[shape]) {
                    shape(shapes, shape);
                }
            }
            if (items == 0) {
                stack[open++] = link;
                stack[open++] = link + 1;
            }
        }
    }

    private boolean enclose() {
        boolean any = false;
        for (int k = 0; k < 3; k++) {
            low[k] = Double.POSITIVE_INFINITY;
            high[k] = Double.NEGATIVE_INFINITY;
        }
        for (int i = 0; i < count; i++) {
            if (lit[i] == 1) {
                any = true;
                for (int k = 0; k < 3; k++) {
                    double at = axes[3 * k] * points[3 * i] + axes[3 * k + 1] * points[3 * i + 1]
                        + axes[3 * k + 2] * points[3 * i + 2];
                    low[k] = Math.min(low[k], at);
                    high[k] = Math.max(high[k], at);
                }
            }
        }
        return any;
    }

    private boolean intersects(float[] box, int at) {
        double hx = ((double) box[at + 3] - box[at]) / 2;
        double hy = ((double) box[at + 4] - box[at + 1]) / 2;
        double hz = ((double) box[at + 5] - box[at + 2]) / 2;
        double x = box[at] + hx;
        double y = box[at + 1] + hy;
        double z = box[at + 2] + hz;
        for (int k = 0; k < 3; k++) {
            double middle = axes[3 * k] * x + axes[3 * k + 1] * y + axes[3 * k + 2] * z;
            double half = Math.abs(axes[3 * k]) * hx + Math.abs(axes[3 * k + 1]) * hy + Math.abs(axes[3 * k + 2]) * hz;
            half += SLACK * (1 + half + Math.abs(middle));
            if (middle + half < low[k] || k < 2 && middle - half > high[k]) {
                return false;
            }
        }
        return true;
    }

    private void shape(Shapes shapes, int shape) {
        boolean convex = shapes.kind[shape] == Shapes.BOX || shapes.kind[shape] == Shapes.CONVEX;
        if (shapes.kind[shape] == Shapes.BOX) {
            box(shapes.data, shape);
            return;
        }
        for (int i = 0; i < count; i++) {
            if (lit[i] == 1 && !(convex && own[i] == shape)) {
                double x = points[3 * i];
                double y = points[3 * i + 1];
                double z = points[3 * i + 2];
                double off = own[i] == shape ? OFF * (1 + Math.abs(x) + Math.abs(y) + Math.abs(z)) : 0;
                double t = rays.test(shapes, shape, x + off * axes[6], y + off * axes[7], z + off * axes[8], axes[6],
                    axes[7], axes[8], Double.MAX_VALUE);
                lit[i] = t == Double.POSITIVE_INFINITY ? (byte) 1 : 0;
            }
        }
    }

    /**
     * Tests a box with the one direction of all rays. A convex shape never shades itself: only its side away from the
     * light would be in shadow, and that side is not tested.
     */
    private void box(double[] m, int shape) {
        int at = shape * Shapes.STRIDE;
        double ix = inverse(m[at] * axes[6] + m[at + 3] * axes[7] + m[at + 6] * axes[8]);
        double iy = inverse(m[at + 1] * axes[6] + m[at + 4] * axes[7] + m[at + 7] * axes[8]);
        double iz = inverse(m[at + 2] * axes[6] + m[at + 5] * axes[7] + m[at + 8] * axes[8]);
        double a = ix < 0 ? m[at + 12] : -m[at + 12];
        double b = iy < 0 ? m[at + 13] : -m[at + 13];
        double c = iz < 0 ? m[at + 14] : -m[at + 14];
        for (int i = 0; i < count; i++) {
            if (lit[i] == 1 && own[i] != shape) {
                double wx = points[3 * i] - m[at + 9];
                double wy = points[3 * i + 1] - m[at + 10];
                double wz = points[3 * i + 2] - m[at + 11];
                double x = m[at] * wx + m[at + 3] * wy + m[at + 6] * wz;
                double y = m[at + 1] * wx + m[at + 4] * wy + m[at + 7] * wz;
                double z = m[at + 2] * wx + m[at + 5] * wy + m[at + 8] * wz;
                double in = Math.max((a - x) * ix, Math.max((b - y) * iy, (c - z) * iz));
                double out = Math.min((-a - x) * ix, Math.min((-b - y) * iy, (-c - z) * iz));
                lit[i] = in <= out && out >= 0 ? 0 : (byte) 1;
            }
        }
    }

    private static double inverse(double d) {
        return Math.abs(d) < 1 / LARGEST ? Math.copySign(LARGEST, d) : 1 / d;
    }
}
