package org.SEAR.raycast;

/**
 * Where a beam meets a convex solid that is centred in the origin of its own frame. Distances are in units of the direction's length; from inside
 * (or on the surface) it is the way out, {@code Double.POSITIVE_INFINITY} where the beam misses. Surfaces belong to the solids.
 */
final class Solids {
    private static final double MISS = Double.POSITIVE_INFINITY;

    private Solids() {
    }

    /** A box of half sizes (hx, hy, hz). */
    static double box(double ox, double oy, double oz, double dx, double dy, double dz, double hx, double hy, double hz) {
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

    /**
     * A solid of revolution about y whose radius is r + slope * y for |y| &lt;= h: slope is 0 in a cylinder, -r / h in a cone. The beam is looked
     * at from its point nearest to the centre, where no digits cancel.
     */
    static double round(double ox, double oy, double oz, double dx, double dy, double dz, double r, double slope, double h) {
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

    /** The outward normal of a box at the surface point (x, y, z), which is replaced by it. */
    static void boxNormal(double[] point, double hx, double hy, double hz) {
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

    /** The outward normal of {@link #round} at a surface point, which is replaced by it. */
    static void roundNormal(double[] point, double r, double slope, double h) {
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
}
