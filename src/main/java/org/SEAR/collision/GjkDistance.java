// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

/**
 * Distance or penetration depth of two convex sets, in double precision and without margins. Distance by Gilbert,
 * Johnson and Keerthi, "A fast procedure for computing the distance between complex objects in three-dimensional space"
 * (1988), depth by {@link Epa}.
 *
 * <p>The distance of two sets is that of their Minkowski difference, all points a - b, from the origin. Only support
 * points of this set are needed, each the difference of one support point of either set. A simplex of at most four of
 * them moves towards the origin. Its point nearest to the origin, by barycentric coordinates, gives the next search
 * direction, and corners without weight are dropped. The plane through each new support point at right angles to the
 * direction gives a lower bound of the distance. The search ends when both bounds agree, or when the sets are further
 * apart than the caller's reach.
 *
 * <p>Accurate to 2e-7 m for shapes of a metre. One pair at a time; not thread-safe.
 */
public final class GjkDistance {
    /** Accuracy of distances, metres. */
    private static final double PRECISION = 1e-7;
    /** Convergence threshold of the search direction, metres. */
    private static final double EXACT = 1e-7;
    /** The same threshold relative to the size of the sets. */
    private static final double EXACT_SHARE = 3e-11;
    /** Largest difference of both bounds, metres, at which the found distance counts instead of the lower bound. */
    private static final double UNPROVED = 1e-6;
    private static final int ITERATIONS = 64;

    /** Unit normal from the second set to the first. */
    public double nx;
    public double ny;
    public double nz;
    /** Distance of the surfaces, metres; negative: penetration depth of the first set along the normal. */
    public double distance;
    /** Nearest point on the second set's surface. */
    final double[] onB = new double[3];
    private final double[][] p = new double[4][3];
    private final double[][] q = new double[4][3];
    private final double[] share = new double[4];
    private final double[] v = new double[3];
    private final double[] best = new double[4];
    private final double[] a = new double[3];
    private final Epa epa = new Epa();
    private int size;

    /**
     * Measures two sets.
     * @param reach metres
     * @return whether their distance is at most this; if not, normal and distance are those of two parallel separating
     *     planes
     */
    public boolean measure(Convex first, Convex second, double reach) {
        return measure(first, second, reach, -1, 0, 0);
    }

    /**
     * Measures two sets.
     * @param gx initial search direction from the second set to the first, likewise gy and gz
     */
    public boolean measure(Convex first, Convex second, double reach, double gx, double gy, double gz) {
        minkowskiDifference(first, second, -gx, -gy, -gz, p[0], q[0]);
        size = 1;
        share[0] = 1;
        double length = approach();
        double proved = Double.NEGATIVE_INFINITY;
        double exact = Math.max(EXACT, EXACT_SHARE * length);
        for (int iteration = 0; iteration < ITERATIONS && length > PRECISION; iteration++) {
            minkowskiDifference(first, second, -v[0], -v[1], -v[2], p[size], q[size]);
            double lower = dot(v, p[size]) / length;
            if (lower > reach) {
                nx = v[0] / length;
                ny = v[1] / length;
                nz = v[2] / length;
                distance = lower;
                return false;
            }
            if (lower > proved) {
                proved = lower;
                nx = v[0] / length;
                ny = v[1] / length;
                nz = v[2] / length;
            }
            if (length - lower <= exact || isKnown()) {
                break;
            }
            size++;
            share[size - 1] = 0;
            double before = length;
            if (size == 4 && holdsOrigin()) {
                length = 0;
                break;
            }
            keepNearest();
            length = approach();
            if (length >= before) {
                break;
            }
        }
        if (length > PRECISION || proved > PRECISION) {
            separated(length, proved);
            return distance <= reach;
        }
        return epa.measure(first, second, p, q, size, this);
    }

    /**
     * Replaces the distance of the measured cores by that of the surfaces.
     * @param first set
     * @param second set
     * @param skin convex radius of the second set, metres
     */
    public void addSkins(Convex first, Convex second, double skin) {
        first.support(-nx, -ny, -nz, a);
        double upper = nx * a[0] + ny * a[1] + nz * a[2];
        second.support(nx, ny, nz, a);
        distance = upper - nx * a[0] - ny * a[1] - nz * a[2];
        onB[0] += skin * nx;
        onB[1] += skin * ny;
        onB[2] += skin * nz;
    }

    /**
     * Replaces the direction found by another one that separates the sets nearly as far.
     * @param first set
     * @param second set
     * @param direction from the second to the first, length 1
     * @param less allowed loss of distance, metres
     */
    public void keep(Convex first, Convex second, double[] direction, double less) {
        double parts = gap(first, second, direction);
        if (parts > distance - less) {
            nx = direction[0];
            ny = direction[1];
            nz = direction[2];
            distance = parts;
        }
    }

    /**
     * Accepts a face as the answer if the other set's support point projects inside it: no other direction then
     * separates the sets as far.
     * @param face of one of the sets
     * @param ofSecond whether it is a face of the second set
     * @param other the set that the face does not belong to
     * @param deepest largest accepted penetration, metres
     * @return whether it is the answer
     */
    public boolean byFace(ContactFeature face, boolean ofSecond, Convex other, double deepest) {
        other.support(-face.nx, -face.ny, -face.nz, a);
        double height = face.height(a[0], a[1], a[2]);
        if (height < -deepest || !face.isUnder(a)) {
            return false;
        }
        double sign = ofSecond ? 1 : -1;
        nx = sign * face.nx;
        ny = sign * face.ny;
        nz = sign * face.nz;
        distance = height;
        double down = ofSecond ? height : 0;
        onB[0] = a[0] - down * face.nx;
        onB[1] = a[1] - down * face.ny;
        onB[2] = a[2] - down * face.nz;
        return true;
    }

    /** Returns the separation of two sets along a unit direction, metres: a lower bound of their distance. */
    public double gap(Convex first, Convex second, double[] direction) {
        first.support(-direction[0], -direction[1], -direction[2], a);
        double upper = dot(direction, a);
        second.support(direction[0], direction[1], direction[2], a);
        return upper - dot(direction, a);
    }

    private void separated(double length, double proved) {
        distance = proved;
        if (Math.abs(length - proved) < UNPROVED) {
            nx = v[0] / length;
            ny = v[1] / length;
            nz = v[2] / length;
            distance = length;
        }
        for (int axis = 0; axis < 3; axis++) {
            onB[axis] = 0;
            for (int i = 0; i < size; i++) {
                onB[axis] += share[i] * q[i][axis];
            }
        }
    }

    /** Finds the support point of the Minkowski difference in a direction, and the second set's support point. */
    static void minkowskiDifference(Convex first, Convex second, double dx, double dy, double dz, double[] point,
        double[] ofSecond) {
        first.support(dx, dy, dz, point);
        second.support(-dx, -dy, -dz, ofSecond);
        for (int axis = 0; axis < 3; axis++) {
            point[axis] -= ofSecond[axis];
        }
    }

    /**
     * Sets {@code v} to the simplex's point nearest to the origin.
     * @return its distance from the origin
     */
    private double approach() {
        for (int axis = 0; axis < 3; axis++) {
            v[axis] = 0;
            for (int i = 0; i < size; i++) {
                v[axis] += share[i] * p[i][axis];
            }
        }
        return Math.sqrt(dot(v, v));
    }

    private boolean isKnown() {
        for (int i = 0; i < size; i++) {
            if (p[i][0] == p[size][0] && p[i][1] == p[size][1] && p[i][2] == p[size][2]) {
                return true;
            }
        }
        return false;
    }

    private boolean holdsOrigin() {
        return beside(0, 1, 2, 3) && beside(0, 1, 3, 2) && beside(0, 2, 3, 1) && beside(1, 2, 3, 0);
    }

    /** Whether the origin is on the same side of three corners as the fourth corner. */
    private boolean beside(int i, int j, int k, int fourth) {
        double ux = p[j][0] - p[i][0];
        double uy = p[j][1] - p[i][1];
        double uz = p[j][2] - p[i][2];
        double wx = p[k][0] - p[i][0];
        double wy = p[k][1] - p[i][1];
        double wz = p[k][2] - p[i][2];
        double mx = uy * wz - uz * wy;
        double my = uz * wx - ux * wz;
        double mz = ux * wy - uy * wx;
        double origin = -(mx * p[i][0] + my * p[i][1] + mz * p[i][2]);
        double other = mx * (p[fourth][0] - p[i][0]) + my * (p[fourth][1] - p[i][1]) + mz * (p[fourth][2] - p[i][2]);
        return origin * other > 0;
    }

    /**
     * Finds the barycentric coordinates of the nearest point and drops corners without weight. The newest corner is the
     * last.
     */
    private void keepNearest() {
        double least = Double.POSITIVE_INFINITY;
        int newest = size - 1;
        for (int i = 0; i < newest; i++) {
            least = edge(i, newest, least);
            for (int j = i + 1; j < newest; j++) {
                least = face(i, j, newest, least);
            }
        }
        if (dot(p[newest], p[newest]) < least) {
            clear(best);
            best[newest] = 1;
        }
        int kept = 0;
        for (int i = 0; i < size; i++) {
            if (best[i] > 0) {
                swap(p, kept, i);
                swap(q, kept, i);
                share[kept++] = best[i];
            }
        }
        size = kept;
    }

    private static void swap(double[][] of, int i, int j) {
        double[] other = of[i];
        of[i] = of[j];
        of[j] = other;
    }

    private static void clear(double[] shares) {
        for (int i = 0; i < 4; i++) {
            shares[i] = 0;
        }
    }

    /**
     * Takes an edge if the foot of the perpendicular lies in it and is nearer.
     * @return smallest squared distance so far
     */
    private double edge(int i, int j, double least) {
        double ex = p[j][0] - p[i][0];
        double ey = p[j][1] - p[i][1];
        double ez = p[j][2] - p[i][2];
        double t = -(ex * p[i][0] + ey * p[i][1] + ez * p[i][2]) / (ex * ex + ey * ey + ez * ez);
        if (!(t > 0 && t < 1)) {
            return least;
        }
        double s = 1 - t;
        double x = s * p[i][0] + t * p[j][0];
        double y = s * p[i][1] + t * p[j][1];
        double z = s * p[i][2] + t * p[j][2];
        double square = x * x + y * y + z * z;
        if (!(square < least)) {
            return least;
        }
        clear(best);
        best[i] = s;
        best[j] = t;
        return square;
    }

    private double face(int i, int j, int k, double least) {
        double ux = p[j][0] - p[i][0];
        double uy = p[j][1] - p[i][1];
        double uz = p[j][2] - p[i][2];
        double wx = p[k][0] - p[i][0];
        double wy = p[k][1] - p[i][1];
        double wz = p[k][2] - p[i][2];
        double uu = ux * ux + uy * uy + uz * uz;
        double uw = ux * wx + uy * wy + uz * wz;
        double ww = wx * wx + wy * wy + wz * wz;
        double up = -(ux * p[i][0] + uy * p[i][1] + uz * p[i][2]);
        double wp = -(wx * p[i][0] + wy * p[i][1] + wz * p[i][2]);
        double whole = uu * ww - uw * uw;
        double s = (ww * up - uw * wp) / whole;
        double t = (uu * wp - uw * up) / whole;
        if (!(s > 0 && t > 0 && s + t < 1)) {
            return least;
        }
        double r = 1 - s - t;
        double x = r * p[i][0] + s * p[j][0] + t * p[k][0];
        double y = r * p[i][1] + s * p[j][1] + t * p[k][1];
        double z = r * p[i][2] + s * p[j][2] + t * p[k][2];
        double square = x * x + y * y + z * z;
        if (!(square < least)) {
            return least;
        }
        clear(best);
        best[i] = r;
        best[j] = s;
        best[k] = t;
        return square;
    }

    private static double dot(double[] u, double[] w) {
        return u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
    }
}
