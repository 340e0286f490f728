// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import org.SEAR.raycast.solid.RayTriangle;

/** Lines in which a fan's plane cuts triangles. One thread. */
final class TriangleCut {
    /**
     * Distance of the fan's origin from a surface, metres, below which it counts as on it. Such a shape is tested ray
     * by ray.
     */
    static final double TOUCHING = 1e-9;

    /** The plane in the triangles' own frame, before scaling. */
    final PlaneCut plane = new PlaneCut();

    private final DepthBuffer depth;
    private double[] own;
    private int shape;
    private double sx;
    private double sy;
    private double sz;
    /** Ends of the last line, in the fan's frame. */
    private double px;
    private double pz;
    private double qx;
    private double qz;

    TriangleCut(DepthBuffer depth) {
        this.depth = depth;
    }

    /**
     * Begins the triangles of a shape.
     * @param fan origin, left, up and forward of the fan in the shape's frame: twelve numbers, not copied
     * @param scaleX scale of the triangles, likewise scaleY and scaleZ
     */
    void start(double[] fan, int number, double scaleX, double scaleY, double scaleZ) {
        own = fan;
        shape = number;
        sx = scaleX;
        sy = scaleY;
        sz = scaleZ;
        PlaneCut cut = plane;
        cut.xa = fan[3] * sx;
        cut.xb = fan[4] * sy;
        cut.xc = fan[5] * sz;
        cut.xd = -(fan[0] * fan[3] + fan[1] * fan[4] + fan[2] * fan[5]);
        cut.ha = fan[6] * sx;
        cut.hb = fan[7] * sy;
        cut.hc = fan[8] * sz;
        cut.hd = -(fan[0] * fan[6] + fan[1] * fan[7] + fan[2] * fan[8]);
        cut.za = fan[9] * sx;
        cut.zb = fan[10] * sy;
        cut.zc = fan[11] * sz;
        cut.zd = -(fan[0] * fan[9] + fan[1] * fan[10] + fan[2] * fan[11]);
    }

    /** Returns the number of the current shape. */
    int shape() {
        return shape;
    }

    /**
     * Intersects one triangle.
     * @param v corners, nine numbers from {@code at} on
     */
    void triangle(float[] v, int at) {
        if (cross(v, at)) {
            segment(v, at);
        }
    }

    /** Computes the line in which the plane cuts a triangle. Returns false if there is none. */
    private boolean cross(float[] v, int at) {
        PlaneCut cut = plane;
        double h0 = cut.height(v[at], v[at + 1], v[at + 2]);
        double h1 = cut.height(v[at + 3], v[at + 4], v[at + 5]);
        double h2 = cut.height(v[at + 6], v[at + 7], v[at + 8]);
        boolean up0 = h0 >= 0;
        boolean up1 = h1 >= 0;
        boolean up2 = h2 >= 0;
        if (up0 == up1 && up1 == up2) {
            return false;
        }
        int lone = up1 == up2 ? 0 : up0 == up2 ? 3 : 6;
        int next = lone == 6 ? 0 : lone + 3;
        int last = lone == 0 ? 6 : lone - 3;
        double hLone = lone == 0 ? h0 : lone == 3 ? h1 : h2;
        double hNext = next == 0 ? h0 : next == 3 ? h1 : h2;
        double hLast = last == 0 ? h0 : last == 3 ? h1 : h2;
        double x0 = cut.x(v[at + lone], v[at + lone + 1], v[at + lone + 2]);
        double z0 = cut.z(v[at + lone], v[at + lone + 1], v[at + lone + 2]);
        double x1 = cut.x(v[at + next], v[at + next + 1], v[at + next + 2]);
        double z1 = cut.z(v[at + next], v[at + next + 1], v[at + next + 2]);
        double x2 = cut.x(v[at + last], v[at + last + 1], v[at + last + 2]);
        double z2 = cut.z(v[at + last], v[at + last + 1], v[at + last + 2]);
        if (hLone >= 0) {
            double f = hLone / (hLone - hNext);
            double g = hLone / (hLone - hLast);
            px = x0 + (x1 - x0) * f;
            pz = z0 + (z1 - z0) * f;
            qx = x0 + (x2 - x0) * g;
            qz = z0 + (z2 - z0) * g;
        } else {
            double f = hNext / (hNext - hLone);
            double g = hLast / (hLast - hLone);
            px = x1 + (x0 - x1) * f;
            pz = z1 + (z0 - z1) * f;
            qx = x2 + (x0 - x2) * g;
            qz = z2 + (z0 - z2) * g;
        }
        return true;
    }

    private void segment(float[] v, int at) {
        double turn = pz * qx - px * qz;
        double ex = qx - px;
        double ez = qz - pz;
        double length = Math.abs(ex) + Math.abs(ez);
        if (Math.abs(turn) <= TOUCHING * length) {
            if (px * qx + pz * qz <= TOUCHING * length) {
                for (int i = 0; i < depth.beams.count; i++) {
                    double x = depth.beams.x[i];
                    double z = depth.beams.z[i];
                    depth.intersect(i, RayTriangle.intersect(v, at, own[0] / sx, own[1] / sy, own[2] / sz,
                        (own[3] * x + own[9] * z) / sx,
                        (own[4] * x + own[10] * z) / sy, (own[5] * x + own[11] * z) / sz), shape);
                }
                return;
            }
            if (turn == 0) {
                return;
            }
        }
        if (turn > 0) {
            depth.line(px, pz, qx, qz, -ez / turn, ex / turn, shape);
        } else {
            depth.line(qx, qz, px, pz, -ez / turn, ex / turn, shape);
        }
    }
}
