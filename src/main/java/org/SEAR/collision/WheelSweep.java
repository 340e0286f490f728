// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Vec3;

/**
 * Moves a wheel along its suspension and finds the highest position in which it touches obstacles from above: in front
 * of its lowest point, there, and behind. A wheel in a gap or before a kerb has two contacts. The tread has a low
 * crown, so that the contact point of a leaning wheel moves without jumps. With lengths along the axle multiplied by a
 * factor, such a wheel is a sphere between two planes. Polygons are exact, other convex sets within 1e-6 m. Allocates
 * nothing. Not thread-safe.
 *
 * <p>Coordinates of the wheel: ahead, up, and aside times that factor, from the suspension's mount, metres.
 */
public final class WheelSweep implements Convex {
    /** Height of the crown as a share of the wheel's width. */
    private static final double CROWN = 0.01;
    /** Gap to a convex set from which on both surfaces count as planes, metres; smaller gaps have vaguer normals. */
    private static final double CLOSE = 2e-4;
    private static final int ITERATIONS = 40;
    /** Distance by which the bounds are larger, metres. */
    private static final double MARGIN = 1e-6;
    /** Part of a normal in the rolling direction up to which the contact is at the lowest point. */
    private static final double LEVEL = 0.05;
    /** Square of a length below which an edge is vertical or a polygon has no area, m^2. */
    private static final double NOTHING = 1e-20;
    /** Largest number of corners of a polygon. */
    private static final int CORNERS = 4;

    private final Vec3 mount = new Vec3();
    private final Vec3 up = new Vec3();
    private final Vec3 ahead = new Vec3();
    private final Vec3 aside = new Vec3();
    private double radius;
    /** Half of the width, metres. */
    private double half;
    private double stretch;
    /** Distance of the side planes from the middle, times the factor, metres. */
    private double wide;
    /** Greatest height of a contact point above the mount, metres, and smallest cosine of its normal. */
    private double limit;
    private double least;
    /** Height of the centre for which it is a convex set, metres. */
    private double height;
    /** Highest contacts in front, below and behind. */
    private final WheelTouch[] highest = {new WheelTouch(), new WheelTouch(), new WheelTouch()};
    private double lowest;
    private int shape;
    private final double[] at = new double[3];
    private final double[] corner = new double[3 * CORNERS];
    /** Ends of the polygon's sections by both side planes. */
    private final double[] sections = new double[12];
    private final int[] ends = new int[2];
    private final GjkDistance gjk = new GjkDistance();

    /**
     * Sets the wheel.
     * @param newMount mount of the suspension, world frame, metres
     * @param newUp unit direction of the suspension, world frame
     * @param newAhead unit direction of rolling, at right angles to it
     * @param newHalf half of the width, metres
     * @param ball whether it is a ball
     */
    public void set(Vec3 newMount, Vec3 newUp, Vec3 newAhead, double newRadius, double newHalf, boolean ball) {
        mount.set(newMount);
        up.set(newUp);
        ahead.set(newAhead);
        aside.cross(up, ahead);
        radius = newRadius;
        half = ball ? radius : newHalf;
        stretch = ball ? 1 : Math.min(Math.min(1, radius / half), Math.sqrt(4 * CROWN * radius / half));
        wide = ball ? radius : stretch * half;
    }

    /**
     * Begins a search.
     * @param newLowest height of the wheel's centre above its mount, metres, above which a contact counts
     * @param newLimit greatest height of a contact point above the mount, metres; higher ones belong to walls
     * @param newLeast smallest cosine between the normal of a contact and the suspension
     */
    public void begin(double newLowest, double newLimit, double newLeast) {
        lowest = newLowest;
        limit = newLimit;
        least = newLeast;
        for (int i = 0; i < highest.length; i++) {
            highest[i].height = lowest;
        }
    }

    /**
     * Computes bounds, in the world frame, of what the wheel may touch in this search.
     * @return whether there may be anything
     */
    public boolean bounds(Aabb box) {
        double low = lowest - radius;
        double middle = (low + limit) / 2;
        double reach = (limit - low) / 2 + MARGIN;
        bound(box, 0, mount.x + middle * up.x, reach, up.x, ahead.x, aside.x);
        bound(box, 1, mount.y + middle * up.y, reach, up.y, ahead.y, aside.y);
        bound(box, 2, mount.z + middle * up.z, reach, up.z, ahead.z, aside.z);
        return limit >= low;
    }

    /** @param u component of the direction up along the axis, likewise f ahead and s aside */
    private void bound(Aabb box, int axis, double middle, double reach, double u, double f, double s) {
        double most = Math.abs(u) * reach + Math.abs(f) * radius + Math.abs(s) * half;
        box.set(axis, middle - most, middle + most);
    }

    /** Sets the number of the shape whose polygons or convex set follow. */
    public void setShape(int newShape) {
        shape = newShape;
    }

    /**
     * Sweeps the wheel to a convex polygon.
     * @param corners x, y and z of three or four corners, world frame, metres
     * @return whether the polygon is the tangent plane at its contact; a convex solid then touches nowhere else
     */
    public boolean polygon(double[] corners, int count) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double top = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 3 * count; i += 3) {
            local(corners, i, corner, i);
            low = Math.min(low, corner[i]);
            high = Math.max(high, corner[i]);
            top = Math.max(top, corner[i + 1]);
            left = Math.min(left, corner[i + 2]);
            right = Math.max(right, corner[i + 2]);
        }
        if (low >= radius || high <= -radius || left > wide || right < -wide || top + radius <= lowest) {
            return false;
        }
        if (face(count)) {
            return true;
        }
        ends[0] = 0;
        ends[1] = 0;
        for (int i = 0; i < count; i++) {
            edge(corner, 3 * i, corner, 3 * ((i + 1) % count));
        }
        for (int side = 0; side < 2; side++) {
            if (ends[side] == 2) {
                edge(sections, 6 * side, sections, 6 * side + 3);
            }
        }
        return false;
    }

    private void local(double[] world, int from, double[] into, int to) {
        double x = world[from] - mount.x;
        double y = world[from + 1] - mount.y;
        double z = world[from + 2] - mount.z;
        into[to] = x * ahead.x + y * ahead.y + z * ahead.z;
        into[to + 1] = x * up.x + y * up.y + z * up.z;
        into[to + 2] = stretch * (x * aside.x + y * aside.y + z * aside.z);
    }

    /** Tests the inside of the polygon; returns whether the sphere touches its plane there. */
    private boolean face(int count) {
        double[] p = corner;
        double ux = p[3] - p[0];
        double uy = p[4] - p[1];
        double uz = p[5] - p[2];
        double wx = p[6] - p[0];
        double wy = p[7] - p[1];
        double wz = p[8] - p[2];
        double x = uy * wz - uz * wy;
        double y = uz * wx - ux * wz;
        double z = ux * wy - uy * wx;
        double square = x * x + y * y + z * z;
        if (square < NOTHING * NOTHING || y * y < NOTHING * square) {
            return false;
        }
        double sense = Math.signum(y);
        double scale = sense / Math.sqrt(square);
        x *= scale;
        y *= scale;
        z *= scale;
        double f = -radius * x;
        double s = -radius * z;
        boolean inside = Math.abs(s) <= wide;
        for (int i = 0; i < count && inside; i++) {
            int a = 3 * i;
            int b = 3 * ((i + 1) % count);
            inside = sense * ((p[b + 2] - p[a + 2]) * (f - p[a]) - (p[b] - p[a]) * (s - p[a + 2])) >= 0;
        }
        if (inside) {
            double height = (x * p[0] + y * p[1] + z * p[2] + radius) / y;
            offer(height, f, height - radius * y, s, false);
        }
        return inside;
    }

    /** Tests an edge; notes where it crosses the side planes. */
    private void edge(double[] from, int a, double[] to, int b) {
        double f = from[a];
        double u = from[a + 1];
        double s = from[a + 2];
        double df = to[b] - f;
        double du = to[b + 1] - u;
        double ds = to[b + 2] - s;
        double first = 0;
        double last = 1;
        for (int side = 0; side < 2 && from == corner; side++) {
            double plane = side == 0 ? wide : -wide;
            if ((s - plane) * (s + ds - plane) < 0) {
                double share = (plane - s) / ds;
                note(side, f + share * df, u + share * du, plane);
                boolean enters = (ds > 0) == (side == 1);
                first = enters ? Math.max(first, share) : first;
                last = enters ? last : Math.min(last, share);
            }
        }
        boolean outside = Math.max(s, s + ds) < -wide || Math.min(s, s + ds) > wide;
        if (outside || first > last) {
            return;
        }
        double square = df * df + ds * ds;
        double t = du > 0 ? last : first;
        if (square > NOTHING) {
            double length = Math.sqrt(square);
            double nearest = -(f * df + s * ds) / square;
            double pf = f + nearest * df;
            double ps = s + nearest * ds;
            double depth = radius * radius - pf * pf - ps * ps;
            if (depth <= 0) {
                return;
            }
            double slope = du / length;
            double highest = nearest + Math.sqrt(depth) * slope / Math.sqrt(1 + slope * slope) / length;
            t = Math.max(first, Math.min(last, highest));
        }
        point(f + t * df, u + t * du, s + t * ds);
    }

    private void note(int side, double f, double u, double s) {
        if (ends[side] < 2) {
            int i = 6 * side + 3 * ends[side]++;
            sections[i] = f;
            sections[i + 1] = u;
            sections[i + 2] = s;
        }
    }

    private void point(double f, double u, double s) {
        double depth = radius * radius - f * f - s * s;
        if (depth > 0) {
            offer(u + Math.sqrt(depth), f, u, s, true);
        }
    }

    private void offer(double height, double f, double u, double s, boolean onEdge) {
        if (height <= lowest || u > limit) {
            return;
        }
        double x = -f / radius;
        double y = (height - u) / radius;
        double z = -stretch * s / radius;
        double length = Math.sqrt(x * x + y * y + z * z);
        WheelTouch touch = touch(x / length);
        if (y >= least * length && height > touch.height) {
            touch.set(height, y / length, onEdge, shape);
            touch.point.set(mount).add(f, ahead).add(u, up).add(s / stretch, aside);
            touch.normal.set(0, 0, 0).add(x / length, ahead).add(y / length, up).add(z / length, aside);
        }
    }

    /** Returns the highest contact so far on the side where a normal points ahead by a cosine. */
    private WheelTouch touch(double cosine) {
        return highest[cosine < -LEVEL ? 0 : cosine > LEVEL ? 2 : 1];
    }

    /** Sweeps the wheel to a convex set, by conservative advancement. */
    public void convex(Convex set) {
        height = limit + radius;
        double gap = Double.POSITIVE_INFINITY;
        double rise = 1;
        for (int i = 0; i < ITERATIONS && gap > CLOSE && rise > 0 && height > lowest; i++) {
            gjk.measure(this, set, Double.POSITIVE_INFINITY, up.x, up.y, up.z);
            gap = gjk.distance;
            rise = gjk.nx * up.x + gjk.ny * up.y + gjk.nz * up.z;
            if (gap <= 0) {
                break;
            }
            height -= (gap > CLOSE ? gap - CLOSE / 2 : gap) / rise;
        }
        if (gap <= 0 || gap > CLOSE || rise < least || height <= lowest) {
            return;
        }
        local(gjk.onB, 0, at, 0);
        WheelTouch touch = touch(gjk.nx * ahead.x + gjk.ny * ahead.y + gjk.nz * ahead.z);
        if (at[1] <= limit && height > touch.height) {
            touch.set(height, rise, false, shape);
            touch.point.set(gjk.onB);
            touch.normal.set(gjk.nx, gjk.ny, gjk.nz);
        }
    }

    /** Finds the support point of the wheel with its centre at the present height. */
    @Override
    public void support(double dx, double dy, double dz, double[] into) {
        double f = dx * ahead.x + dy * ahead.y + dz * ahead.z;
        double u = dx * up.x + dy * up.y + dz * up.z;
        double s = (dx * aside.x + dy * aside.y + dz * aside.z) / stretch;
        double length = Math.sqrt(f * f + u * u + s * s);
        double side = length > 0 ? radius * s / length : 0;
        double across = radius / length;
        if (Math.abs(side) > wide) {
            side = Math.copySign(wide, side);
            double rim = Math.sqrt(f * f + u * u);
            across = rim > 0 ? Math.sqrt(Math.max(0, radius * radius - wide * wide)) / rim : 0;
        }
        f *= across;
        u = u * across + height;
        s = side / stretch;
        into[0] = mount.x + f * ahead.x + u * up.x + s * aside.x;
        into[1] = mount.y + f * ahead.y + u * up.y + s * aside.y;
        into[2] = mount.z + f * ahead.z + u * up.z + s * aside.z;
    }

    /**
     * Returns the highest contact.
     * @param other a contact to leave out; null for none
     * @return null if there is none
     */
    public WheelTouch highest(WheelTouch other) {
        WheelTouch best = null;
        for (int i = 0; i < highest.length; i++) {
            if (highest[i] != other && highest[i].height > (best == null ? lowest : best.height)) {
                best = highest[i];
            }
        }
        return best;
    }
}
