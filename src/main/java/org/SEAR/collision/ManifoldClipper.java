// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.Arrays;

/**
 * Contact manifold of two sets, with up to four points. {@link GjkDistance} gives one point and a direction. Of the
 * faces in that direction the one with the best aligned normal is the reference face. The other, the incident face, is
 * clipped by the side planes of the reference face (Sutherland and Hodgman, "Reentrant polygon clipping", 1974). Its
 * corners below or little above the reference face are the contact points, all in one step, so that bodies rest stably.
 * Of more than four it keeps the lowest, the one furthest from it, and those furthest to either side of their line.
 * Of a round face the first one is in the direction of the load, where the body would tip over. Of a face with more
 * than four corners it keeps both ends of the edge in that direction.
 * Without a face, {@link LineContact} finds the ends of a common line; otherwise it keeps the one point.
 */
public final class ManifoldClipper {
    /** Distance at which surfaces already carry load, metres, so that all corners of a resting face are in contact. */
    public static final float SKIN = 5e-4f;
    /** Distance above which surfaces have no contact, metres. */
    public static final float BREAKING = 0.02f;
    /** Difference of cosines within which both faces are equally aligned. */
    private static final double EVEN = 1e-3;
    private static final int CORNERS = 4;
    /** Tilt towards the load that decides between corners of equal height, radians. */
    private static final double TILT = 1e-3;
    /**
     * Sine of the angle between load and normal below which the load has no direction along the face: a body at rest
     * tilts by up to 1e-5 as a push moves its centre of pressure.
     */
    private static final double LEVEL = 1e-3;
    /** Depth below the corners of the edge at which another corner counts, metres. */
    private static final double DEEPER = 1e-5;

    /** Features of both sets, in the world; filled by the caller. */
    public final ContactFeature ofA = new ContactFeature();
    public final ContactFeature ofB = new ContactFeature();
    private final LineContact line = new LineContact();
    private final int[] chosen = new int[CORNERS];
    private double reach = BREAKING;
    /** Direction in which the load tips the body, in the world; zeros if it is unknown. */
    private final double[] load = new double[3];
    private boolean byLoad;
    /** Whether the last base had more than four corners, and its middle, in the world, metres. */
    private boolean many;
    private final double[] middle = new double[3];

    /**
     * Sets the direction in which the load tips the body.
     * @param direction {x, y, z} in the world; its part along the normal doesn't count
     */
    public void setLoad(double[] direction) {
        System.arraycopy(direction, 0, load, 0, load.length);
        byLoad = false;
        many = false;
    }

    /** Whether the last contact points depend on the direction of the load. */
    public boolean isByLoad() {
        return byLoad;
    }

    /** Middle of the last base, in the world, metres; null unless it has more than four corners. */
    public double[] getMiddle() {
        return many ? middle : null;
    }

    /** @param metres largest height of a contact point */
    public void setReach(double metres) {
        reach = metres;
    }

    /**
     * Adds the contact points.
     * @param nearest with the direction from B to A
     */
    public void find(GjkDistance nearest, ContactPoints into) {
        if (!faces(nearest.nx, nearest.ny, nearest.nz, into) && !line.find(ofA, ofB, nearest, reach, into)) {
            into.add(nearest.nx, nearest.ny, nearest.nz, nearest.onB[0], nearest.onB[1], nearest.onB[2],
                nearest.distance);
        }
    }

    /**
     * Adds the corners of the common face.
     * @param nx direction from B to A, likewise ny and nz
     * @return whether there is a common face
     */
    public boolean faces(double nx, double ny, double nz, ContactPoints into) {
        double alongA = ofA.flat ? -(nx * ofA.nx + ny * ofA.ny + nz * ofA.nz) : 0;
        double alongB = ofB.flat ? nx * ofB.nx + ny * ofB.ny + nz * ofB.nz : 0;
        if (Math.max(alongA, alongB) < ContactFeature.ALIGNED) {
            return false;
        }
        ofA.turnCircle(load);
        ofB.turnCircle(load);
        byLoad = ofA.isCircle() || ofB.isCircle();
        boolean onB = alongB >= alongA - EVEN && !(ofB.isCircle() && !ofA.isCircle() && alongA >= alongB - EVEN);
        ContactFeature reference = onB ? ofB : ofA;
        ContactFeature incident = onB ? ofA : ofB;
        // triangles of a mesh share a base: only a base that has many corners itself counts
        boolean whole = incident.count > CORNERS || incident.count == CORNERS && reference.count >= CORNERS;
        incident.clip(reference);
        many = !byLoad && whole && incident.count > CORNERS;
        byLoad |= many;
        if (many) {
            findMiddle(incident);
        }
        int corners = many ? chooseAtEdge(reference, incident) : choose(reference, incident);
        double sign = onB ? 1 : -1;
        for (int i = 0; i < corners; i++) {
            int corner = chosen[i];
            double height = reference.height(incident.x(corner), incident.y(corner), incident.z(corner));
            double down = onB ? height : 0;
            into.add(sign * reference.nx, sign * reference.ny, sign * reference.nz,
                incident.x(corner) - down * reference.nx,
                incident.y(corner) - down * reference.ny, incident.z(corner) - down * reference.nz, height);
        }
        return corners > 0;
    }

    private void findMiddle(ContactFeature base) {
        Arrays.fill(middle, 0);
        for (int i = 0; i < base.count; i++) {
            middle[0] += base.x(i) / base.count;
            middle[1] += base.y(i) / base.count;
            middle[2] += base.z(i) / base.count;
        }
    }

    /**
     * Chooses both ends of the edge that the load would tip the body over, and the two corners that make the largest
     * quadrilateral with them: wherever the load moves, the points are chosen again before it reaches a side of the
     * quadrilateral.
     */
    private int chooseAtEdge(ContactFeature reference, ContactFeature incident) {
        int lowest = lowest(reference, incident);
        int first = edge(reference, incident);
        if (lowest < 0 || first < 0) {
            return choose(reference, incident);
        }
        int second = (first + 1) % incident.count;
        double least = height(reference, incident, lowest) + DEEPER;
        int third = first;
        int fourth = first;
        double most = SKIN * SKIN;
        for (int i = 2; i < incident.count; i++) {
            int one = (first + i) % incident.count;
            double area = Math.abs(area(reference, incident, first, second, one));
            for (int k = i; k < incident.count && height(reference, incident, one) < reach; k++) {
                int other = (first + k) % incident.count;
                double whole = area + Math.abs(area(reference, incident, first, one, other));
                if (whole > most + SKIN * SKIN && height(reference, incident, other) < reach) {
                    most = whole;
                    third = one;
                    fourth = k > i ? other : first;
                }
            }
        }
        boolean deep = height(reference, incident, first) <= least || height(reference, incident, second) <= least
            || height(reference, incident, third) <= least || height(reference, incident, fourth) <= least;
        if (!deep) {
            return choose(reference, incident);
        }
        chosen[0] = first;
        chosen[1] = second;
        chosen[2] = third;
        chosen[3] = fourth;
        return third == first ? 2 : fourth == first ? 3 : 4;
    }

    /** Returns the first corner of the edge that a ray from the middle along the load crosses, or -1. */
    private int edge(ContactFeature reference, ContactFeature incident) {
        double along = reference.nx * load[0] + reference.ny * load[1] + reference.nz * load[2];
        double tx = load[0] - along * reference.nx;
        double ty = load[1] - along * reference.ny;
        double tz = load[2] - along * reference.nz;
        double ux = reference.ny * tz - reference.nz * ty;
        double uy = reference.nz * tx - reference.nx * tz;
        double uz = reference.nx * ty - reference.ny * tx;
        if (tx * tx + ty * ty + tz * tz < LEVEL * LEVEL) {
            return -1;
        }
        for (int i = 0; i < incident.count; i++) {
            int next = (i + 1) % incident.count;
            double here = along(incident, i, ux, uy, uz);
            double there = along(incident, next, ux, uy, uz);
            boolean within = height(reference, incident, i) < reach && height(reference, incident, next) < reach;
            if (within && here <= 0 != there <= 0) {
                double share = here / (here - there);
                double ahead = along(incident, i, tx, ty, tz);
                if (ahead + share * (along(incident, next, tx, ty, tz) - ahead) > 0) {
                    return i;
                }
            }
        }
        return -1;
    }

    /** Returns the coordinate of a corner from the middle along a direction. */
    private double along(ContactFeature of, int i, double dx, double dy, double dz) {
        return dx * (of.x(i) - middle[0]) + dy * (of.y(i) - middle[1]) + dz * (of.z(i) - middle[2]);
    }

    private static double height(ContactFeature reference, ContactFeature incident, int i) {
        return reference.height(incident.x(i), incident.y(i), incident.z(i));
    }

    /** Chooses the lowest corner, the one furthest from it, and those furthest from their line on either side. */
    private int choose(ContactFeature reference, ContactFeature incident) {
        int lowest = lowest(reference, incident);
        if (lowest < 0) {
            return 0;
        }
        int count = 0;
        chosen[count++] = lowest;
        int far = lowest;
        double most = 0;
        for (int i = 0; i < incident.count; i++) {
            double distance = square(incident.x(i) - incident.x(lowest)) + square(incident.y(i) - incident.y(lowest))
                + square(incident.z(i) - incident.z(lowest));
            if (distance > most && reference.height(incident.x(i), incident.y(i), incident.z(i)) < reach) {
                most = distance;
                far = i;
            }
        }
        if (far == lowest) {
            return count;
        }
        chosen[count++] = far;
        for (int side = -1; side <= 1; side += 2) {
            int best = -1;
            most = 0;
            for (int i = 0; i < incident.count; i++) {
                double area = side * area(reference, incident, lowest, far, i);
                if (area > most + SKIN * SKIN && reference.height(incident.x(i), incident.y(i),
                    incident.z(i)) < reach) {
                    most = area;
                    best = i;
                }
            }
            if (best >= 0) {
                chosen[count++] = best;
            }
        }
        return count;
    }

    /**
     * Returns the lowest corner within the reach, or -1. If the load counts, a small tilt in its direction decides
     * between corners of equal height.
     */
    private int lowest(ContactFeature reference, ContactFeature incident) {
        int lowest = -1;
        double least = Double.POSITIVE_INFINITY;
        double tilt = byLoad ? TILT : 0;
        for (int i = 0; i < incident.count; i++) {
            double height = reference.height(incident.x(i), incident.y(i), incident.z(i));
            double tilted = height - tilt * (load[0] * incident.x(i) + load[1] * incident.y(i)
                + load[2] * incident.z(i));
            if (height < reach && tilted < least) {
                least = tilted;
                lowest = i;
            }
        }
        return lowest;
    }

    private static double square(double value) {
        return value * value;
    }

    /** Returns twice the signed area of a triangle of corners, + counter-clockwise seen from above the face. */
    private static double area(ContactFeature reference, ContactFeature incident, int a, int b, int c) {
        double ux = incident.x(b) - incident.x(a);
        double uy = incident.y(b) - incident.y(a);
        double uz = incident.z(b) - incident.z(a);
        double vx = incident.x(c) - incident.x(a);
        double vy = incident.y(c) - incident.y(a);
        double vz = incident.z(c) - incident.z(a);
        return reference.nx * (uy * vz - uz * vy) + reference.ny * (uz * vx - ux * vz)
            + reference.nz * (ux * vy - uy * vx);
    }
}
