// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

/**
 * Contact manifold of two sets, with up to four points. {@link GjkDistance} gives one point and a direction. Of the
 * faces in that direction the one with the best aligned normal is the reference face. The other, the incident face, is
 * clipped by the side planes of the reference face (Sutherland and Hodgman, "Reentrant polygon clipping", 1974). Its
 * corners below or little above the reference face are the contact points, all in one step, so that bodies rest stably.
 * Of more than four it keeps the lowest, the one furthest from it, and those furthest to either side of their line.
 * Of a round face the first one is in the direction of the load, where the body would tip over.
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

    /** Features of both sets, in the world; filled by the caller. */
    public final ContactFeature ofA = new ContactFeature();
    public final ContactFeature ofB = new ContactFeature();
    private final LineContact line = new LineContact();
    private final int[] chosen = new int[CORNERS];
    private double reach = BREAKING;
    /** Direction in which the load tips the body, in the world; zeros if it is unknown. */
    private final double[] load = new double[3];
    private boolean byLoad;

    /**
     * Sets the direction in which the load tips the body.
     * @param direction {x, y, z} in the world; its part along the normal doesn't count
     */
    public void setLoad(double[] direction) {
        System.arraycopy(direction, 0, load, 0, load.length);
        byLoad = false;
    }

    /** Whether the last contact points depend on the direction of the load. */
    public boolean isByLoad() {
        return byLoad;
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
        incident.clip(reference);
        int corners = choose(reference, incident);
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
