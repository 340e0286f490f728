package org.SEAR.collision;

/**
 * Where two convex sets are nearest to each other, or how deep they are in each other, in double precision and without margins. The distance is by
 * Gilbert, Johnson and Keerthi, "A fast procedure for computing the distance between complex objects in three-dimensional space" (1988), the depth
 * by {@link Epa}.
 *
 * <p>How it works: the distance of two sets is that of their Minkowski difference, all points a - b, from the origin. Of that set only support
 * points are needed, each the difference of one support point of either set. A simplex of at most four of them is moved towards the origin: its
 * point nearest to the origin, by barycentric coordinates, gives the next direction to look in, and what no longer helps leaves it. The plane
 * through each new support point at right angles to the direction proves a distance from below, so the search ends as soon as that and what was
 * found agree, or the sets are proved to be farther apart than anybody asked for.
 *
 * <p>A distance is good to 2e-7 m for shapes of a metre. One pair at a time; not for several threads.
 */
public final class GjkDistance {
    /** Distances are this good, metres. */
    private static final double PRECISION = 1e-7;
    /** And the direction so that it would not change more, metres. */
    private static final double EXACT = 1e-7;
    /** The same as a share of how large the sets are. */
    private static final double EXACT_SHARE = 3e-11;
    /** If the search ends that much short of the proved distance, what is proved counts, metres. */
    private static final double UNPROVED = 1e-6;
    private static final int ITERATIONS = 64;

    /** From the second set to the first, length 1. */
    public double nx;
    public double ny;
    public double nz;
    /** Between the surfaces, metres; negative if the sets overlap: how far the first would have to go along the normal. */
    public double distance;
    /** The point of the second set's surface that is nearest. */
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
     *
     * @param reach metres
     * @return whether they are not farther apart than that; if not, normal and distance are those of two parallel planes that part them
     */
    public boolean measure(Convex first, Convex second, double reach) {
        return measure(first, second, reach, -1, 0, 0);
    }

    /**
     * Measures two sets.
     *
     * @param gx direction from the second to the first that is probably the answer, likewise gy and gz
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
     * Puts the distance of the surfaces in the place of that of the cores that were measured.
     *
     * @param first set
     * @param second set
     * @param skin how much nearer its surface is than the second core, metres
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
     * Puts another direction in the place of that found if it parts the sets nearly as far.
     *
     * @param first set
     * @param second set
     * @param direction from the second to the first, length 1
     * @param less by how much less far it may part them, metres
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
     * Takes a face as the answer if the other set's support point stands over it: then no other direction parts both as far, and there is nothing to
     * search for.
     *
     * @param face of one of the sets
     * @param ofSecond whether it is the second set's
     * @param other the set whose face it is not
     * @param deepest how deep in each other they may be for that, metres
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

    /** How far apart two sets are at least: the distance of the planes that touch them at right angles to a direction of length 1, metres. */
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

    /** The support point of the Minkowski difference of both sets in a direction, and the point of the second set there. */
    static void minkowskiDifference(Convex first, Convex second, double dx, double dy, double dz, double[] point, double[] ofSecond) {
        first.support(dx, dy, dz, point);
        second.support(-dx, -dy, -dz, ofSecond);
        for (int axis = 0; axis < 3; axis++) {
            point[axis] -= ofSecond[axis];
        }
    }

    /**
     * The point of the simplex that is nearest to the origin.
     *
     * @return how far it is
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

    /** Whether the origin lies on the same side of three corners as the fourth. */
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

    /** Finds the shares of the corners in the nearest point, and drops corners without. The newest corner is the last. */
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
     *
     * @return the square of the least distance so far
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
