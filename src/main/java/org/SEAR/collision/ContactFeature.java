// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import org.SEAR.geometry.Placement;

/**
 * Contact feature of a solid in a direction: a face with its outward normal, a line (an edge, or the line of a curved
 * side) or a corner. Filled in the solid's frame, then placed in the world.
 */
public final class ContactFeature {
    /** Largest number of corners, including those that clipping adds. */
    static final int MOST = 32;
    /** Smallest cosine between contact direction and normal of a face contact (6 degrees). */
    static final double ALIGNED = 0.995;
    /** Sine of the slope of a face below which it counts as level. */
    private static final double LEVEL = 1e-6;

    int count;
    /** Whether it is a face with a normal. */
    boolean flat;
    /** Whether the face's outline is a circle, which has no straight edges. */
    private boolean circle;
    /** Whether the first corner of a circle is the lowest, since the face is tilted. */
    private boolean tilted;
    /** Radius of curvature across a line, at its first and last corner, metres; 0: a sharp edge. */
    private double firstRadius;
    private double lastRadius;
    /** Corners that begin and end the line found by {@link #findLine}. */
    private int first;
    private int last;
    /** Outward normal of a face. */
    public double nx;
    public double ny;
    public double nz;
    private double[] at = new double[3 * MOST];
    private double[] other = new double[3 * MOST];
    private final double[] above = new double[MOST];

    public void clear() {
        count = 0;
        flat = false;
        circle = false;
        tilted = false;
        firstRadius = 0;
        lastRadius = 0;
        nx = 0;
        ny = 0;
        nz = 0;
    }

    void add(double x, double y, double z) {
        int i = 3 * count++;
        at[i] = x;
        at[i + 1] = y;
        at[i + 2] = z;
    }

    void setNormal(double x, double y, double z) {
        flat = true;
        nx = x;
        ny = y;
        nz = z;
    }

    /**
     * Makes it a face with a round outline.
     * @param isTilted whether its first corner has to stay where it is
     */
    void setCircle(boolean isTilted) {
        circle = true;
        tilted = isTilted;
    }

    boolean isCircle() {
        return circle;
    }

    /** Turns the corners of a level circle about its centre, the first one into the direction {dx, dy, dz}. */
    void turnCircle(double[] direction) {
        double along = nx * direction[0] + ny * direction[1] + nz * direction[2];
        double ux = direction[0] - along * nx;
        double uy = direction[1] - along * ny;
        double uz = direction[2] - along * nz;
        double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
        if (!circle || tilted || length < LEVEL) {
            return;
        }
        int half = 3 * (count / 2);
        double mx = (at[0] + at[half]) / 2;
        double my = (at[1] + at[half + 1]) / 2;
        double mz = (at[2] + at[half + 2]) / 2;
        double radius = Math.sqrt((at[0] - mx) * (at[0] - mx) + (at[1] - my) * (at[1] - my)
            + (at[2] - mz) * (at[2] - mz));
        double scale = radius / length;
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * i / count;
            double u = scale * Math.cos(angle);
            double w = scale * Math.sin(angle);
            at[3 * i] = mx + u * ux + w * (ny * uz - nz * uy);
            at[3 * i + 1] = my + u * uy + w * (nz * ux - nx * uz);
            at[3 * i + 2] = mz + u * uz + w * (nx * uy - ny * ux);
        }
    }

    /** Sets the radius of curvature across a line of two corners, at each of them, metres. */
    void setCurvature(double atFirst, double atLast) {
        firstRadius = atFirst;
        lastRadius = atLast;
    }

    /**
     * Finds the line that is furthest in a direction: the highest corner and the higher one of its neighbours.
     * @return false if there is no straight line
     */
    boolean findLine(double dx, double dy, double dz) {
        if (count < 2 || circle) {
            return false;
        }
        first = 0;
        last = 1;
        if (count > 2) {
            double most = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < count; i++) {
                double next = along(i, dx, dy, dz);
                if (next > most) {
                    most = next;
                    first = i;
                }
            }
            int before = (first + count - 1) % count;
            int after = (first + 1) % count;
            last = along(before, dx, dy, dz) > along(after, dx, dy, dz) ? before : after;
        }
        return true;
    }

    /** Returns a corner's coordinate along a direction, metres. */
    private double along(int i, double dx, double dy, double dz) {
        return dx * x(i) + dy * y(i) + dz * z(i);
    }

    /** Returns a coordinate of a point of the line: axis 0 to 2, share of the line from 0 to 1. */
    double onLine(int axis, double share) {
        return at[3 * first + axis] + share * (at[3 * last + axis] - at[3 * first + axis]);
    }

    /** Returns the radius of curvature at a point of the line, metres. */
    double radiusOnLine(double share) {
        return firstRadius + share * (lastRadius - firstRadius);
    }

    double x(int i) {
        return at[3 * i];
    }

    double y(int i) {
        return at[3 * i + 1];
    }

    double z(int i) {
        return at[3 * i + 2];
    }

    /** Transforms it from the solid's frame to the world. */
    public void place(Placement to) {
        for (int i = 0; i < count; i++) {
            to.transform(x(i), y(i), z(i), at, 3 * i);
        }
        double x = nx;
        double y = ny;
        double z = nz;
        nx = to.m00 * x + to.m01 * y + to.m02 * z;
        ny = to.m10 * x + to.m11 * y + to.m12 * z;
        nz = to.m20 * x + to.m21 * y + to.m22 * z;
    }

    /** Whether it is a face whose normal is nearly a direction. */
    public boolean isAlong(double dx, double dy, double dz) {
        return flat && nx * dx + ny * dy + nz * dz > ALIGNED;
    }

    /** Returns the height of a point above the face's plane, metres. */
    double height(double x, double y, double z) {
        return nx * (x - at[0]) + ny * (y - at[1]) + nz * (z - at[2]);
    }

    /** Whether a point projects inside this face. */
    boolean isUnder(double[] point) {
        int left = 0;
        int right = 0;
        for (int i = 0; i < count; i++) {
            int k = 3 * i;
            int next = 3 * ((i + 1) % count);
            double ex = at[next] - at[k];
            double ey = at[next + 1] - at[k + 1];
            double ez = at[next + 2] - at[k + 2];
            double px = point[0] - at[k];
            double py = point[1] - at[k + 1];
            double pz = point[2] - at[k + 2];
            double side = nx * (ey * pz - ez * py) + ny * (ez * px - ex * pz) + nz * (ex * py - ey * px);
            left += side > 0 ? 1 : 0;
            right += side < 0 ? 1 : 0;
        }
        return flat && count > 2 && (left == count || right == count);
    }

    /** Clips this feature to the prism over a face. */
    void clip(ContactFeature face) {
        double mx = 0;
        double my = 0;
        double mz = 0;
        for (int i = 0; i < face.count; i++) {
            mx += face.x(i) / face.count;
            my += face.y(i) / face.count;
            mz += face.z(i) / face.count;
        }
        for (int i = 0; i < face.count && count > 0; i++) {
            int next = (i + 1) % face.count;
            double ex = face.x(next) - face.x(i);
            double ey = face.y(next) - face.y(i);
            double ez = face.z(next) - face.z(i);
            double px = ey * face.nz - ez * face.ny;
            double py = ez * face.nx - ex * face.nz;
            double pz = ex * face.ny - ey * face.nx;
            double offset = px * face.x(i) + py * face.y(i) + pz * face.z(i);
            boolean outward = px * mx + py * my + pz * mz <= offset;
            cut(outward ? px : -px, outward ? py : -py, outward ? pz : -pz, outward ? offset : -offset);
        }
    }

    /** Keeps the part below a plane. */
    private void cut(double px, double py, double pz, double offset) {
        boolean whole = true;
        for (int i = 0; i < count; i++) {
            above[i] = px * x(i) + py * y(i) + pz * z(i) - offset;
            whole &= above[i] <= 0;
        }
        if (whole) {
            return;
        }
        int kept = 0;
        for (int i = 0; i < count; i++) {
            int next = (i + 1) % count;
            double here = above[i];
            double there = above[next];
            if (here <= 0) {
                kept = keep(kept, x(i), y(i), z(i));
            }
            if (here < 0 && there > 0 || here > 0 && there < 0) {
                double t = here / (here - there);
                kept = keep(kept, x(i) + t * (x(next) - x(i)), y(i) + t * (y(next) - y(i)),
                    z(i) + t * (z(next) - z(i)));
            }
        }
        double[] swap = at;
        at = other;
        other = swap;
        count = kept;
    }

    private int keep(int kept, double x, double y, double z) {
        if (kept == MOST) {
            return kept;
        }
        other[3 * kept] = x;
        other[3 * kept + 1] = y;
        other[3 * kept + 2] = z;
        return kept + 1;
    }
}
