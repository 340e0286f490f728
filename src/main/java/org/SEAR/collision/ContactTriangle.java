// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import javax.vecmath.Vector3f;
import org.SEAR.geometry.Placement;

/** Two-sided triangle of a fixed mesh, in the world. */
public final class ContactTriangle implements Convex {
    private static final double NOTHING = 1e-14;
    /** Smallest cosine between its normal and the direction to a ball that is about to roll onto it (8 degrees). */
    private static final double FLAT = 0.99;
    private final double[] at = new double[9];
    private double nx;
    private double ny;
    private double nz;
    /** Mean of the corners, and a bound of the distance of its points from there, metres. */
    private double mx;
    private double my;
    private double mz;
    private double bound;
    private final double[] point = new double[3];
    private double lowest;
    private double highest;

    /**
     * @param corners in the mesh's frame
     * @param place of that frame
     * @return false if it has no area
     */
    public boolean set(Vector3f[] corners, Placement place) {
        for (int i = 0; i < 3; i++) {
            place.transform(corners[i].x, corners[i].y, corners[i].z, at, 3 * i);
        }
        double ux = at[3] - at[0];
        double uy = at[4] - at[1];
        double uz = at[5] - at[2];
        double wx = at[6] - at[0];
        double wy = at[7] - at[1];
        double wz = at[8] - at[2];
        nx = uy * wz - uz * wy;
        ny = uz * wx - ux * wz;
        nz = ux * wy - uy * wx;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        nx /= length;
        ny /= length;
        nz /= length;
        return length > NOTHING;
    }

    void copy(ContactTriangle from) {
        System.arraycopy(from.at, 0, at, 0, at.length);
        nx = from.nx;
        ny = from.ny;
        nz = from.nz;
        mx = (at[0] + at[3] + at[6]) / 3;
        my = (at[1] + at[4] + at[7]) / 3;
        mz = (at[2] + at[5] + at[8]) / 3;
        bound = 0;
        for (int i = 0; i < 9; i += 3) {
            bound = Math.max(bound, Math.sqrt(square(at[i], at[i + 1], at[i + 2])));
        }
    }

    private double square(double x, double y, double z) {
        return (x - mx) * (x - mx) + (y - my) * (y - my) + (z - mz) * (z - mz);
    }

    /** Compares corners, coordinate by coordinate. */
    int compare(ContactTriangle other) {
        int order = 0;
        for (int i = 0; i < at.length && order == 0; i++) {
            order = Double.compare(at[i], other.at[i]);
        }
        return order;
    }

    /** Returns the cosine between a direction and the normal; negative for the back. */
    double cosine(double dx, double dy, double dz) {
        return nx * dx + ny * dy + nz * dz;
    }

    /**
     * Whether a point lies on it, which must be a copy.
     * @param within tolerance, metres
     */
    boolean holds(double[] p, double within) {
        if (square(p[0], p[1], p[2]) > (bound + within) * (bound + within)) {
            return false;
        }
        double off = nx * (p[0] - at[0]) + ny * (p[1] - at[1]) + nz * (p[2] - at[2]);
        boolean inside = Math.abs(off) <= within;
        for (int i = 0; i < 9 && inside; i += 3) {
            int next = (i + 3) % 9;
            double ex = at[next] - at[i];
            double ey = at[next + 1] - at[i + 1];
            double ez = at[next + 2] - at[i + 2];
            double px = p[0] - at[i];
            double py = p[1] - at[i + 1];
            double pz = p[2] - at[i + 2];
            double area = nx * (ey * pz - ez * py) + ny * (ez * px - ex * pz) + nz * (ex * py - ey * px);
            inside = area >= -within * Math.sqrt(ex * ex + ey * ey + ez * ez);
        }
        return inside;
    }

    /**
     * Returns the height of its highest corner above the plane of another triangle, metres, on the side that a
     * direction points to.
     */
    double rise(ContactTriangle over, double dx, double dy, double dz) {
        double side = over.cosine(dx, dy, dz) < 0 ? -1 : 1;
        double highest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 9; i += 3) {
            highest = Math.max(highest, side * over.cosine(at[i] - over.at[0], at[i + 1] - over.at[1],
                at[i + 2] - over.at[2]));
        }
        return highest;
    }

    /**
     * Adds a contact with its plane.
     * @param p point on the triangle
     * @param dx direction from there to the body, length 1, likewise dy and dz
     * @param distance of the body in that direction, metres; negative: penetration
     * @param ball radius of the body if it is a ball, metres, else 0
     */
    void addPlane(double[] p, double dx, double dy, double dz, double distance, double ball, ContactPoints into) {
        double cosine = cosine(dx, dy, dz);
        double side = cosine < 0 ? -1 : 1;
        double ux = side * nx;
        double uy = side * ny;
        double uz = side * nz;
        // a ball touches the plane below its centre, where a flat triangle continues
        double centre = ball > 0 && side * cosine > FLAT ? distance + ball : 0;
        double above = side * cosine * centre;
        double height = centre > 0 ? above - ball : side * cosine * distance;
        into.add(ux, uy, uz, p[0] + centre * dx - above * ux, p[1] + centre * dy - above * uy,
            p[2] + centre * dz - above * uz, height);
    }

    /** Whether a set reaches within {@code reach} metres of the triangle's plane; also measures {@link #depth}. */
    public boolean isNear(Convex other, double reach) {
        double plane = nx * at[0] + ny * at[1] + nz * at[2];
        other.support(-nx, -ny, -nz, point);
        lowest = nx * point[0] + ny * point[1] + nz * point[2] - plane;
        other.support(nx, ny, nz, point);
        highest = nx * point[0] + ny * point[1] + nz * point[2] - plane;
        return lowest <= reach && highest >= -reach;
    }

    /** Returns the penetration through the plane, metres, measured from the side with most of the set. */
    public double depth() {
        return Math.min(-lowest, highest);
    }

    /** Sets a feature to the side with most of the set. */
    public void front(ContactFeature into) {
        double side = highest > -lowest ? 1 : -1;
        feature(side * nx, side * ny, side * nz, into);
    }

    @Override
    public void support(double dx, double dy, double dz, double[] into) {
        int best = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 9; i += 3) {
            double along = at[i] * dx + at[i + 1] * dy + at[i + 2] * dz;
            if (along > most) {
                most = along;
                best = i;
            }
        }
        into[0] = at[best];
        into[1] = at[best + 1];
        into[2] = at[best + 2];
    }

    /** Sets a feature to the side that faces a direction. */
    public void feature(double dx, double dy, double dz, ContactFeature into) {
        into.clear();
        for (int i = 0; i < 9; i += 3) {
            into.add(at[i], at[i + 1], at[i + 2]);
        }
        double side = nx * dx + ny * dy + nz * dz < 0 ? -1 : 1;
        into.setNormal(side * nx, side * ny, side * nz);
    }
}
