// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

/** A solid of revolution about the y axis whose radius is r + slope * y for |y| &lt;= h. Immutable. */
public final class RayRound implements RaySolid {
    private static final double MISS = Double.POSITIVE_INFINITY;

    private final double r;
    private final double slope;
    private final double h;

    private RayRound(double r, double slope, double h) {
        this.r = r;
        this.slope = slope;
        this.h = h;
    }

    /**
     * Creates a solid cylinder.
     * @param radius metres
     */
    public static RayRound cylinder(double radius, double halfHeight) {
        return new RayRound(radius, 0, halfHeight);
    }

    /**
     * Creates a solid cone with the apex at +halfHeight and the base at -halfHeight.
     * @param radius of the base, metres
     */
    public static RayRound cone(double radius, double halfHeight) {
        return new RayRound(radius / 2, -radius / (2 * halfHeight), halfHeight);
    }

    /** Solves from the ray's closest point to the centre to avoid cancellation. */
    @Override
    public double intersect(double ox, double oy, double oz, double dx, double dy, double dz) {
        double shift = -(ox * dx + oy * dy + oz * dz) / (dx * dx + dy * dy + dz * dz);
        double px = ox + shift * dx;
        double py = oy + shift * dy;
        double pz = oz + shift * dz;
        double in = Double.NEGATIVE_INFINITY;
        double out = MISS;
        if (dy != 0) {
            double a = (-h - py) / dy;
            double b = (h - py) / dy;
            in = dy > 0 ? a : b;
            out = dy > 0 ? b : a;
        } else if (Math.abs(py) > h) {
            return MISS;
        }
        double rho = r + slope * py;
        double a = dx * dx + dz * dz - slope * slope * dy * dy;
        double b = px * dx + pz * dz - rho * slope * dy;
        double c = px * px + pz * pz - rho * rho;
        if (a == 0) {
            if (b != 0) {
                double t = -c / (2 * b);
                in = b < 0 ? Math.max(in, t) : in;
                out = b < 0 ? out : Math.min(out, t);
            } else if (c > 0) {
                return MISS;
            }
        } else {
            double disc = b * b - a * c;
            if (disc < 0) {
                if (a > 0) {
                    return MISS;
                }
                disc = 0;
            }
            double q = -(b + (b >= 0 ? Math.sqrt(disc) : -Math.sqrt(disc)));
            double t1 = q / a;
            double t2 = q == 0 ? t1 : c / q;
            double first = Math.min(t1, t2);
            double last = Math.max(t1, t2);
            if (a > 0) {
                in = Math.max(in, first);
                out = Math.min(out, last);
            } else if (slope * dy > 0) {
                in = Math.max(in, last);
            } else {
                out = Math.min(out, first);
            }
        }
        if (!(in <= out)) {
            return MISS;
        }
        in += shift;
        out += shift;
        return out < 0 ? MISS : in >= 0 ? in : out;
    }

    @Override
    public void normal(double[] point) {
        double off = Math.hypot(point[0], point[2]);
        double side = (off - (r + slope * point[1])) / Math.sqrt(1 + slope * slope);
        double end = Math.abs(point[1]) - h;
        boolean apex = point[1] > 0 && r + slope * h <= 0;
        if (end > side && !apex || off == 0) {
            point[0] = 0;
            point[1] = Math.signum(point[1]);
            point[2] = 0;
            return;
        }
        double length = off * Math.sqrt(1 + slope * slope);
        point[0] /= length;
        point[1] = -slope * off / length;
        point[2] /= length;
    }

    @Override
    public double reach(double dx, double dy, double dz) {
        double radius = r + Math.abs(slope) * h;
        return Math.abs(dy) * h + Math.sqrt(Math.max(0, 1 - dy * dy)) * radius;
    }
}
