// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

/**
 * Contact points of two nearly parallel lines: edges, or the lines of curved sides. It gives both ends of the part that
 * they share, so that a body rests along the whole line. The gap at an end is the distance of both centres of
 * curvature less both radii, so lines that cross have gaps at their ends. Then the point where they cross is a contact
 * point too. Not thread-safe.
 */
final class LineContact {
    /** Smallest cosine of the angle between lines with a common part (18 degrees). */
    private static final double PARALLEL = 0.95;
    /** Shortest common part, metres. */
    private static final double SHORTEST = 1e-4;
    /** Radius of curvature of two sharp edges together, metres: what their convex radii come to. */
    private static final double SHARP = 2e-3;
    /** Height of both ends above the point where lines cross, from which that point counts as well, metres. */
    private static final double CROSSING = 1e-5;
    /** Cosine between line and normal above which the contact is at a corner. */
    private static final double CROOKED = 0.1;
    /** Difference of distances sideways of parallel lines, metres. */
    private static final double EQUAL = 1e-9;

    /** Direction of the common line, length 1. */
    private final double[] t = new double[3];
    /** Direction from B to A in which the lines were found, and the contact normal, both of length 1. */
    private final double[] found = new double[3];
    private final double[] n = new double[3];
    /** Vector from B's centre of curvature to A's at a position along the line, metres. */
    private final double[] apart = new double[3];
    private ContactFeature a;
    private ContactFeature b;
    /** Position along the common line of each line's start, and its change along the whole line, metres. */
    private double startA;
    private double startB;
    private double lengthA;
    private double lengthB;

    /**
     * Adds the contact points.
     * @param nearest with the direction from B to A
     * @param reach largest gap of a contact point, metres
     * @return false, and adds nothing, if they have no common line within the reach
     */
    boolean find(ContactFeature ofA, ContactFeature ofB, GjkDistance nearest, double reach, ContactPoints into) {
        a = ofA;
        b = ofB;
        found[0] = nearest.nx;
        found[1] = nearest.ny;
        found[2] = nearest.nz;
        if (!a.findLine(-found[0], -found[1], -found[2]) || !b.findLine(found[0], found[1], found[2])) {
            return false;
        }
        straighten();
        System.arraycopy(found, 0, n, 0, 3);
        if (!align()) {
            return false;
        }
        double low = Math.max(Math.min(startA, startA + lengthA), Math.min(startB, startB + lengthB));
        double high = Math.min(Math.max(startA, startA + lengthA), Math.max(startB, startB + lengthB));
        if (high - low < SHORTEST) {
            return false;
        }
        double crossing = crossing(low, high);
        improveNormal(crossing);
        int before = into.size();
        double least = Math.min(add(low, reach, into), add(high, reach, into));
        if (gap(crossing) < least - CROSSING) {
            add(crossing, reach, into);
        }
        return into.size() > before;
    }

    /**
     * Makes the normal perpendicular to the line that it is more nearly perpendicular to: over a long line, the error
     * that the search for the smallest distance leaves would be a large difference of gaps.
     */
    private void straighten() {
        double u = along(a);
        double w = along(b);
        ContactFeature of = Math.abs(u) < Math.abs(w) ? a : b;
        double along = Math.abs(u) < Math.abs(w) ? u : w;
        if (Math.abs(along) > CROOKED) {
            return;
        }
        double length = length(of);
        for (int axis = 0; axis < 3; axis++) {
            found[axis] -= along * (of.onLine(axis, 1) - of.onLine(axis, 0)) / length;
        }
        double rest = Math.sqrt(dot(found, found));
        for (int axis = 0; axis < 3; axis++) {
            found[axis] /= rest;
        }
    }

    /** Returns the cosine between a line and the normal. */
    private double along(ContactFeature of) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            sum += found[axis] * (of.onLine(axis, 1) - of.onLine(axis, 0));
        }
        return sum / length(of);
    }

    private static double length(ContactFeature of) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double side = of.onLine(axis, 1) - of.onLine(axis, 0);
            square += side * side;
        }
        return Math.sqrt(square);
    }

    /** Finds the common direction; returns false if the lines are not nearly parallel. */
    private boolean align() {
        double u = direction(a);
        double ux = t[0];
        double uy = t[1];
        double uz = t[2];
        double w = direction(b);
        double cosine = ux * t[0] + uy * t[1] + uz * t[2];
        if (!(u > 0 && w > 0 && Math.abs(cosine) > PARALLEL)) {
            return false;
        }
        double sign = cosine < 0 ? -1 : 1;
        t[0] = ux + sign * t[0];
        t[1] = uy + sign * t[1];
        t[2] = uz + sign * t[2];
        double length = Math.sqrt(dot(t, t));
        for (int axis = 0; axis < 3; axis++) {
            t[axis] /= length;
        }
        startA = position(a, 0);
        startB = position(b, 0);
        lengthA = position(a, 1) - startA;
        lengthB = position(b, 1) - startB;
        return true;
    }

    /** Sets the direction of a line along the surface; returns its length, metres, or 0. */
    private double direction(ContactFeature of) {
        for (int axis = 0; axis < 3; axis++) {
            t[axis] = of.onLine(axis, 1) - of.onLine(axis, 0);
        }
        double up = dot(t, n);
        for (int axis = 0; axis < 3; axis++) {
            t[axis] -= up * n[axis];
        }
        double length = Math.sqrt(dot(t, t));
        for (int axis = 0; axis < 3; axis++) {
            t[axis] /= length;
        }
        return length > SHORTEST ? length : 0;
    }

    private double position(ContactFeature of, double share) {
        return t[0] * of.onLine(0, share) + t[1] * of.onLine(1, share) + t[2] * of.onLine(2, share);
    }

    /** Sets the vector between the centres of curvature at a position along the line; returns both radii, metres. */
    private double measure(double at) {
        double shareA = (at - startA) / lengthA;
        double shareB = (at - startB) / lengthB;
        double radii = a.radiusOnLine(shareA) + b.radiusOnLine(shareB) + SHARP;
        for (int axis = 0; axis < 3; axis++) {
            apart[axis] = a.onLine(axis, shareA) - b.onLine(axis, shareB) + radii * found[axis];
        }
        double along = dot(apart, t);
        for (int axis = 0; axis < 3; axis++) {
            apart[axis] -= along * t[axis];
        }
        return radii;
    }

    /**
     * Makes the normal of curved sides exact: from one centre of curvature to the other, where the lines cross. The
     * search for the smallest distance finds it only to the square root of its precision.
     */
    private void improveNormal(double at) {
        double radii = measure(at);
        double length = Math.sqrt(dot(apart, apart));
        if (radii > 2 * SHARP && length > radii / 2) {
            for (int axis = 0; axis < 3; axis++) {
                n[axis] = apart[axis] / length;
            }
        }
    }

    /** Returns the position between two others where the lines are least apart sideways, or the middle. */
    private double crossing(double low, double high) {
        measure(low);
        double x = t[1] * n[2] - t[2] * n[1];
        double y = t[2] * n[0] - t[0] * n[2];
        double z = t[0] * n[1] - t[1] * n[0];
        double first = x * apart[0] + y * apart[1] + z * apart[2];
        measure(high);
        double last = x * apart[0] + y * apart[1] + z * apart[2];
        double share = Math.abs(last - first) > EQUAL ? Math.max(0, Math.min(1, first / (first - last))) : 0.5;
        return low + share * (high - low);
    }

    /** Returns the gap at a position along the line, metres. */
    private double gap(double at) {
        double radii = measure(at);
        double along = dot(apart, n);
        return (along > 0 ? Math.sqrt(dot(apart, apart)) : along) - radii;
    }

    /** Adds a point of the common part if it is within the reach; returns its gap, metres. */
    private double add(double at, double reach, ContactPoints into) {
        double gap = gap(at);
        if (gap <= reach) {
            double shareB = (at - startB) / lengthB;
            double radius = b.radiusOnLine(shareB) + SHARP / 2;
            double side = radius / (a.radiusOnLine((at - startA) / lengthA) + SHARP / 2 + radius);
            double up = radius - side * dot(apart, n);
            into.add(n[0], n[1], n[2], b.onLine(0, shareB) - radius * found[0] + up * n[0] + side * apart[0],
                b.onLine(1, shareB) - radius * found[1] + up * n[1] + side * apart[1],
                b.onLine(2, shareB) - radius * found[2] + up * n[2] + side * apart[2], gap);
        }
        return gap;
    }

    private static double dot(double[] u, double[] w) {
        return u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
    }
}
