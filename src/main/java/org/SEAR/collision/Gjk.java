package org.SEAR.collision;

/**
 * Whether two convex sets have a point in common, in double precision (Gilbert, Johnson and Keerthi 1988, the version that only looks for the origin
 * in the Minkowski difference).
 */
public final class Gjk {
    /** A convex set: its farthest point in a direction. */
    public interface Support {
        /** @param d direction, not zero, world frame @param into takes {x, y, z} */
        void farthest(double[] d, double[] into);
    }

    private static final int ROUNDS = 64;
    private static final double NOTHING = 1e-18;
    private final double[][] simplex = new double[4][];
    private int size;
    private double[] direction;

    private Gjk() {
    }

    public static boolean intersect(Support a, Support b) {
        return new Gjk().run(a, b);
    }

    private boolean run(Support a, Support b) {
        direction = new double[] {1, 0.3, 0.2};
        simplex[0] = difference(a, b);
        size = 1;
        direction = negative(simplex[0]);
        for (int round = 0; round < ROUNDS; round++) {
            if (dot(direction, direction) < NOTHING) {
                return true;
            }
            double[] point = difference(a, b);
            if (dot(point, direction) < 0) {
                return false;
            }
            System.arraycopy(simplex, 0, simplex, 1, 3);
            simplex[0] = point;
            size = Math.min(4, size + 1);
            if (holdsOrigin()) {
                return true;
            }
        }
        return true;
    }

    private double[] difference(Support a, Support b) {
        double[] p = new double[3];
        double[] q = new double[3];
        a.farthest(direction, p);
        b.farthest(negative(direction), q);
        return minus(p, q);
    }

    /** Keeps the part of the simplex that is nearest to the origin, newest point first, and aims from there at the origin. */
    private boolean holdsOrigin() {
        switch (size) {
            case 2:
                line();
                return false;
            case 3:
                triangle(simplex[0], simplex[1], simplex[2]);
                return false;
            default:
                return tetrahedron();
        }
    }

    private void line() {
        double[] ab = minus(simplex[1], simplex[0]);
        double[] ao = negative(simplex[0]);
        if (dot(ab, ao) > 0) {
            direction = cross(cross(ab, ao), ab);
        } else {
            size = 1;
            direction = ao;
        }
    }

    private void keepLine(double[] a, double[] b) {
        simplex[0] = a;
        simplex[1] = b;
        size = 2;
        line();
    }

    private void triangle(double[] a, double[] b, double[] c) {
        double[] ab = minus(b, a);
        double[] ac = minus(c, a);
        double[] ao = negative(a);
        double[] normal = cross(ab, ac);
        if (dot(cross(normal, ac), ao) > 0) {
            if (dot(ac, ao) > 0) {
                keepLine(a, c);
            } else {
                keepLine(a, b);
            }
        } else if (dot(cross(ab, normal), ao) > 0) {
            keepLine(a, b);
        } else {
            boolean above = dot(normal, ao) > 0;
            simplex[0] = a;
            simplex[1] = above ? b : c;
            simplex[2] = above ? c : b;
            size = 3;
            direction = above ? normal : negative(normal);
        }
    }

    private boolean tetrahedron() {
        double[] a = simplex[0];
        double[] b = simplex[1];
        double[] c = simplex[2];
        double[] d = simplex[3];
        double[] ao = negative(a);
        if (dot(outward(a, b, c, d), ao) > 0) {
            triangle(a, b, c);
        } else if (dot(outward(a, c, d, b), ao) > 0) {
            triangle(a, c, d);
        } else if (dot(outward(a, d, b, c), ao) > 0) {
            triangle(a, d, b);
        } else {
            return true;
        }
        return false;
    }

    /** Normal of the face (a, b, c) away from the fourth corner. */
    private static double[] outward(double[] a, double[] b, double[] c, double[] fourth) {
        double[] normal = cross(minus(b, a), minus(c, a));
        return dot(normal, minus(fourth, a)) > 0 ? negative(normal) : normal;
    }

    private static double[] minus(double[] p, double[] q) {
        return new double[] {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
    }

    private static double[] negative(double[] p) {
        return new double[] {-p[0], -p[1], -p[2]};
    }

    private static double dot(double[] p, double[] q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    }

    private static double[] cross(double[] p, double[] q) {
        return new double[] {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    }
}
