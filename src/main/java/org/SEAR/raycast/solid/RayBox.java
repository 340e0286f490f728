// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

/** Intersection of a ray with a box centred at the origin of its own frame. Distances follow {@link RaySolid}. */
public final class RayBox {
    private static final double MISS = Double.POSITIVE_INFINITY;

    private RayBox() {
    }

    /** Returns the distance to a box of half sizes (hx, hy, hz). */
    public static double intersect(double ox, double oy, double oz, double dx, double dy, double dz, double hx,
        double hy, double hz) {
        double in = Double.NEGATIVE_INFINITY;
        double out = MISS;
        if (dx != 0) {
            double a = (-hx - ox) / dx;
            double b = (hx - ox) / dx;
            in = dx > 0 ? a : b;
            out = dx > 0 ? b : a;
        } else if (Math.abs(ox) > hx) {
            return MISS;
        }
        if (dy != 0) {
            double a = (-hy - oy) / dy;
            double b = (hy - oy) / dy;
            in = Math.max(in, dy > 0 ? a : b);
            out = Math.min(out, dy > 0 ? b : a);
        } else if (Math.abs(oy) > hy) {
            return MISS;
        }
        if (dz != 0) {
            double a = (-hz - oz) / dz;
            double b = (hz - oz) / dz;
            in = Math.max(in, dz > 0 ? a : b);
            out = Math.min(out, dz > 0 ? b : a);
        } else if (Math.abs(oz) > hz) {
            return MISS;
        }
        return in > out || out < 0 ? MISS : in >= 0 ? in : out;
    }

    /** Replaces the surface point (x, y, z) by the box's outward normal there. */
    public static void normal(double[] point, double hx, double hy, double hz) {
        double ex = Math.abs(point[0]) - hx;
        double ey = Math.abs(point[1]) - hy;
        double ez = Math.abs(point[2]) - hz;
        int axis = ex >= ey && ex >= ez ? 0 : ey >= ez ? 1 : 2;
        double sign = Math.signum(point[axis]);
        point[0] = 0;
        point[1] = 0;
        point[2] = 0;
        point[axis] = sign;
    }
}
