// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * Tipping angle of a robot as a rigid body on its wheels' contact points. It tips about an edge of their convex hull on
 * a slope of atan(distance of the centre of mass from the edge / its height above the edge). Soft springs lean, and let
 * it tip slightly earlier. It also tips about this edge when it brakes by more than gravity times the tangent of the
 * angle. Body frame, metres; immutable, any thread.
 */
public final class Stability {
    /** Slope angle in degrees below which SEAR warns. */
    public static final double CRITICAL = 15;
    /** Width of the feet's hull below which it counts as a line, metres. */
    private static final double FLAT = 1e-6;
    /** Largest number of feet that are examined. */
    private static final int MAX_FEET = 20;
    /** Directions in steps of 45 degrees from ahead to the left. */
    private static final String[] WAYS = {"forwards", "forwards to the left", "to the left", "backwards to the left",
        "backwards", "backwards to the right", "to the right", "forwards to the right"};

    /** Slope on which it tips over, degrees; negative if it does at rest, NaN without three feet that span an area. */
    public final double degrees;
    private final double[] centre;
    private final double[][] support;
    private final double[] slope;
    /** Whether the centre of mass was moved to the middle of the wheels. */
    private final boolean balanced;
    private final double gravity;
    private String way = "";
    /** Distance of the centre of mass from the tipping edge, metres; negative outside. */
    private double room;

    /**
     * Robot at rest on its wheels.
     * @param centre of mass {x, y, z}
     * @param feet contact points of its wheels, {x, y, z} each
     * @param balanced whether the centre of mass was moved to the middle of the wheels, because too few parts have a
     *     mass
     * @param gravity m/s^2
     */
    Stability(double[] centre, double[][] feet, boolean balanced, double gravity) {
        this.centre = centre.clone();
        this.balanced = balanced;
        this.gravity = gravity;
        double[][] hull = hull(feet);
        support = hull.length < 3 ? new double[0][] : hull;
        slope = slope(centre, feet);
        degrees = support.length == 0 ? Double.NaN : least();
    }

    /**
     * Returns the slope of the plane through three feet that has no foot below it and the centre of mass above these
     * three.
     */
    private static double[] slope(double[] centre, double[][] feet) {
        for (int i = 0; i < Math.min(feet.length, MAX_FEET); i++) {
            for (int j = 0; j < i; j++) {
                for (int k = 0; k < j; k++) {
                    double[] plane = plane(feet[i], feet[j], feet[k], centre);
                    if (plane != null && isLowest(plane, feet[i], feet)) {
                        return plane;
                    }
                }
            }
        }
        return new double[2];
    }

    /**
     * Returns the slope along x and z of the plane through three feet; null if the centre of mass is not above these.
     */
    private static double[] plane(double[] a, double[] b, double[] c, double[] centre) {
        double[] ab = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        double[] ac = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        double area = ab[0] * ac[2] - ab[2] * ac[0];
        double px = centre[0] - a[0];
        double pz = centre[2] - a[2];
        double toB = (px * ac[2] - pz * ac[0]) / area;
        double toC = (ab[0] * pz - ab[2] * px) / area;
        if (Math.abs(area) < FLAT || toB < -FLAT || toC < -FLAT || toB + toC > 1 + FLAT) {
            return null;
        }
        return new double[] {(ab[1] * ac[2] - ab[2] * ac[1]) / area, (ab[0] * ac[1] - ab[1] * ac[0]) / area};
    }

    private static boolean isLowest(double[] plane, double[] on, double[][] feet) {
        return Arrays.stream(feet).allMatch(foot -> foot[1] - on[1] > plane[0] * (foot[0] - on[0])
            + plane[1] * (foot[2] - on[2]) - FLAT);
    }

    /**
     * Slope along x and z of the plane on which it stands, in its own frame, metres per metre; 0 if it does not stand.
     */
    double[] slope() {
        return slope.clone();
    }

    private double least() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < support.length; i++) {
            double[] a = support[i];
            double[] b = support[(i + 1) % support.length];
            double ex = b[0] - a[0];
            double ez = b[2] - a[2];
            double length = Math.hypot(ex, ez);
            double inside = (ex * (centre[2] - a[2]) - ez * (centre[0] - a[0])) / length;
            double along = (ex * (centre[0] - a[0]) + ez * (centre[2] - a[2])) / (length * length);
            double foot = a[1] + Math.max(0, Math.min(1, along)) * (b[1] - a[1]);
            double angle = Math.toDegrees(Math.atan2(inside, Math.max(0, centre[1] - foot)));
            if (angle < least) {
                least = angle;
                room = inside;
                long eighth = Math.round(Math.atan2(ez, -ex) / (Math.PI / 4));
                way = WAYS[Math.floorMod(eighth, WAYS.length)];
            }
        }
        return least;
    }

    /** Returns the corners of the convex hull in x and z, counter-clockwise from x to z. */
    private static double[][] hull(double[][] feet) {
        double[][] sorted = feet.clone();
        Arrays.sort(sorted, Comparator.<double[]>comparingDouble(foot -> foot[0]).thenComparingDouble(foot -> foot[2]));
        List<double[]> hull = new ArrayList<>();
        half(sorted, hull);
        for (int i = 0; i < sorted.length / 2; i++) {
            double[] foot = sorted[i];
            sorted[i] = sorted[sorted.length - 1 - i];
            sorted[sorted.length - 1 - i] = foot;
        }
        half(sorted, hull);
        return hull.toArray(new double[0][]);
    }

    /** Adds one side of the hull, without its last corner. */
    private static void half(double[][] sorted, List<double[]> hull) {
        int first = hull.size();
        for (double[] foot : sorted) {
            while (hull.size() - first > 1 && !turns(hull.get(hull.size() - 2), hull.get(hull.size() - 1), foot)) {
                hull.remove(hull.size() - 1);
            }
            hull.add(foot);
        }
        if (hull.size() > first) {
            hull.remove(hull.size() - 1);
        }
    }

    /** Whether c is beside the line from a to b, on the side of the hull. */
    private static boolean turns(double[] a, double[] b, double[] c) {
        double ex = b[0] - a[0];
        double ez = b[2] - a[2];
        return ex * (c[2] - a[2]) - ez * (c[0] - a[0]) > FLAT * Math.hypot(ex, ez);
    }

    /** Centre of mass, {x, y, z}. */
    public double[] getCentre() {
        return centre.clone();
    }

    /** Corners of the support polygon, {x, y, z} each; empty with fewer than three feet, or feet on a line. */
    public double[][] getSupport() {
        double[][] corners = new double[support.length][];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = support[i].clone();
        }
        return corners;
    }

    /** Whether SEAR warns of it. */
    public boolean isCritical() {
        return degrees < CRITICAL;
    }

    /** Returns a description of when it tips over; empty if its wheels don't determine that. */
    public String getWords() {
        if (Double.isNaN(degrees)) {
            return "";
        }
        String words = degrees <= 0
            ? String.format(Locale.ROOT, "falls over %s at rest: its centre of mass at x %.3f, y %.3f, z %.3f of its "
                + "frame is %.3f m outside its wheels", way, centre[0] + 0.0, centre[1] + 0.0, centre[2] + 0.0, -room)
            : String.format(Locale.ROOT, "tips over %s on a slope of %.0f degrees, or when it brakes or turns with "
                + "more than %.1f m/s\u00b2", way,
                Math.floor(degrees), Math.tan(Math.toRadians(degrees)) * gravity);
        return words + (isCritical() ? ". Put weight lower or further inwards, or its wheels further apart" : "")
            + (balanced ? ". SEAR assumes its weight in the middle of its wheels until two of its "
                + "shapes have a mass" : "");
    }
}
