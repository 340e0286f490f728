// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.Arrays;

/**
 * Chooses the points of a contact with a mesh that support a body. Points with nearly the same normal form a group; the
 * groups come in the order of their lowest points, and only the highest ones are dropped. Of a group it chooses the
 * lowest point, and those that touch first when the body tilts a little or more in any of some directions: corners of
 * the lower convex hull of the gaps. Other points cannot touch before these do. The choice does not depend on the order
 * of the points. Not thread-safe.
 */
public final class SupportPoints {
    /** Largest number of points of a manifold. */
    private static final int CORNERS = 4;
    /** Largest number of manifolds. */
    private static final int MOST = 16;
    /** Cosine above which normals belong to one group (1.15 degrees). */
    private static final double SAME = 0.9998;
    /** The same for a ball, for which only normals and gaps count (0.008 degrees). */
    private static final double EQUAL_NORMAL = 1 - 1e-8;
    /** Angles by which the body tilts, radians. */
    private static final double[] TILTS = {1e-3, 1e-2};
    /** Directions in which the body tilts. */
    private static final int DIRECTIONS = 8;
    /** Distance below which two points are the same, and depth below others that counts, metres. */
    private static final double EQUAL = 1e-5;

    private final double[] cosines = new double[DIRECTIONS];
    private final double[] sines = new double[DIRECTIONS];
    private final int[] chosen = new int[MOST * CORNERS];
    private final int[] starts = new int[MOST + 1];
    /** Lowest point of each manifold's group. */
    private final int[] lowests = new int[MOST];
    private int manifolds;
    private int count;
    /** Whether a point is in a group; then the points of the present group. */
    private boolean[] taken = new boolean[16];
    private int[] members = new int[16];
    private int size;
    private ContactPoints points;

    public SupportPoints() {
        for (int i = 0; i < DIRECTIONS; i++) {
            double angle = 2 * Math.PI * (i + 0.5) / DIRECTIONS;
            cosines[i] = Math.cos(angle);
            sines[i] = Math.sin(angle);
        }
    }

    /**
     * Chooses from the points of a body.
     * @param ball whether the body is a ball: no tilt changes its contacts
     * @param fast whether the body moves further in a substep than a resting one could
     */
    public void choose(ContactPoints from, boolean ball, boolean fast) {
        points = from;
        manifolds = 0;
        count = 0;
        if (taken.length < from.size()) {
            taken = new boolean[2 * from.size()];
            members = new int[2 * from.size()];
        }
        Arrays.fill(taken, 0, from.size(), false);
        double same = ball ? EQUAL_NORMAL : SAME;
        for (int lowest = takeGroup(same); lowest >= 0; lowest = takeGroup(same)) {
            int first = count;
            if (!ball) {
                tilt(lowest, first);
            }
            if (isBelowAll(lowest, first)) {
                add(lowest, lowest, first);
            }
            if (fast) {
                spread(lowest, first);
            }
            end(lowest);
        }
    }

    /** Number of manifolds. */
    public int size() {
        return manifolds;
    }

    /** Number of points of a manifold. */
    public int size(int manifold) {
        return starts[manifold + 1] - starts[manifold];
    }

    /** Index of the point whose normal is the manifold's. */
    public int getNormal(int manifold) {
        return lowests[manifold];
    }

    /** Index of a manifold's point among those to choose from. */
    public int get(int manifold, int i) {
        return chosen[starts[manifold] + i];
    }

    /** Takes the lowest point that is left, and those with its normal, as the present group; returns it, or -1. */
    private int takeGroup(double same) {
        int lowest = -1;
        for (int i = 0; i < points.size() && manifolds < MOST; i++) {
            if (!taken[i] && (lowest < 0 || isLess(points.height(i), i, points.height(lowest), lowest))) {
                lowest = i;
            }
        }
        size = 0;
        for (int i = 0; i < points.size() && lowest >= 0; i++) {
            if (!taken[i] && (points.cosine(i, lowest) > same || i == lowest)) {
                taken[i] = true;
                members[size++] = i;
            }
        }
        return lowest;
    }

    /** Chooses the points that touch first when the body tilts about the lowest point. */
    private void tilt(int lowest, int first) {
        double nx = points.nx(lowest);
        double ny = points.ny(lowest);
        double nz = points.nz(lowest);
        boolean acrossX = Math.abs(nx) < 0.6;
        double length = Math.sqrt(ny * ny + (acrossX ? nz * nz : nx * nx));
        double ux = acrossX ? 0 : ny / length;
        double uy = (acrossX ? nz : -nx) / length;
        double uz = acrossX ? -ny / length : 0;
        double wx = ny * uz - nz * uy;
        double wy = nz * ux - nx * uz;
        double wz = nx * uy - ny * ux;
        for (double angle : TILTS) {
            for (int i = 0; i < DIRECTIONS; i++) {
                double u = angle * cosines[i];
                double w = angle * sines[i];
                add(touchesFirst(u * ux + w * wx, u * uy + w * wy, u * uz + w * wz), lowest, first);
            }
        }
    }

    /**
     * Fills a manifold with the points furthest from the chosen ones. A fast body turns so far in a substep that it
     * would pass through the mesh beside them.
     */
    private void spread(int lowest, int first) {
        while (count > first && count - first < Math.min(CORNERS, size) && manifolds < MOST) {
            int best = -1;
            double furthest = EQUAL * EQUAL;
            for (int k = 0; k < size; k++) {
                double nearest = nearestChosen(members[k], first);
                if (nearest > furthest || best >= 0 && nearest == furthest
                    && isLess(points.height(members[k]), members[k], points.height(best), best)) {
                    furthest = nearest;
                    best = members[k];
                }
            }
            if (best < 0) {
                return;
            }
            add(best, lowest, first);
        }
    }

    /** Returns the squared distance to the nearest chosen point, m^2. */
    private double nearestChosen(int point, int first) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = first; i < count; i++) {
            least = Math.min(least, points.square(chosen[i], point));
        }
        return least;
    }

    /** Returns the lowest point of the group after a tilt, which changes heights by this much per metre. */
    private int touchesFirst(double x, double y, double z) {
        int best = -1;
        double least = 0;
        for (int k = 0; k < size; k++) {
            int i = members[k];
            double height = points.height(i) + x * points.x(i) + y * points.y(i) + z * points.z(i);
            if (best < 0 || isLess(height, i, least, best)) {
                best = i;
                least = height;
            }
        }
        return best;
    }

    /** Compares heights, then positions, then normals. */
    private boolean isLess(double height, int i, double other, int k) {
        return height < other || height == other && points.compare(i, k) < 0;
    }

    private boolean isBelowAll(int point, int first) {
        for (int i = first; i < count; i++) {
            if (points.height(chosen[i]) < points.height(point) + EQUAL) {
                return false;
            }
        }
        return true;
    }

    /** Adds a point unless one of the group's is there; begins a new manifold after four. */
    private void add(int point, int lowest, int first) {
        for (int i = first; i < count; i++) {
            if (points.square(chosen[i], point) < EQUAL * EQUAL) {
                return;
            }
        }
        if (count - starts[manifolds] == CORNERS) {
            end(lowest);
        }
        if (manifolds < MOST) {
            chosen[count++] = point;
        }
    }

    /** Ends a manifold that has points. */
    private void end(int lowest) {
        if (manifolds < MOST && count > starts[manifolds]) {
            lowests[manifolds] = lowest;
            starts[++manifolds] = count;
        }
    }
}
