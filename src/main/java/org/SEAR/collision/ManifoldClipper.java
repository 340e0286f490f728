package org.SEAR.collision;

/**
 * The contact manifold of two sets: where they touch, as up to four points. {@link GjkDistance} gives one point and a direction; of the faces that
 * look along that, the one that is more at right angles to it is the reference face. The other, the incident face, is clipped by the planes through
 * the reference face's sides (Sutherland and Hodgman, "Reentrant polygon clipping", 1974), and the corners of what is left that lie below or little
 * above the reference face are the contact, all in the same step: so things stand still. Of more than four the lowest stays, the one farthest from
 * it, and those farthest to either side of their line. Where no face is part of it (edge on edge), the one point stands.
 */
public final class ManifoldClipper {
    /** Surfaces this close already carry each other, metres: a face that rests has all its corners in touch. */
    public static final float SKIN = 5e-4f;
    /** Surfaces farther apart than this have no contact, metres. */
    public static final float BREAKING = 0.02f;
    /** A face whose normal has at least this cosine to the direction of the contact is part of it (6 degrees). */
    private static final double ALIGNED = 0.995;
    /** Faces of both are equally good within this. */
    private static final double EVEN = 1e-3;
    private static final int CORNERS = 4;

    /** What each turns to the other, in the world; filled in by the caller. */
    public final ContactFeature ofA = new ContactFeature();
    public final ContactFeature ofB = new ContactFeature();
    private final int[] chosen = new int[CORNERS];
    private double reach = BREAKING;

    /** @param metres how far apart two points may be */
    public void setReach(double metres) {
        reach = metres;
    }

    /**
     * Adds the points of contact.
     *
     * @param nearest from B to A
     */
    public void find(GjkDistance nearest, ContactPoints into) {
        if (!faces(nearest.nx, nearest.ny, nearest.nz, into)) {
            into.add(nearest.nx, nearest.ny, nearest.nz, nearest.onB[0], nearest.onB[1], nearest.onB[2], nearest.distance);
        }
    }

    /**
     * Adds the corners of what both share.
     *
     * @param nx direction from B to A
     * @return whether there is such a patch
     */
    public boolean faces(double nx, double ny, double nz, ContactPoints into) {
        double alongA = ofA.flat ? -(nx * ofA.nx + ny * ofA.ny + nz * ofA.nz) : 0;
        double alongB = ofB.flat ? nx * ofB.nx + ny * ofB.ny + nz * ofB.nz : 0;
        if (Math.max(alongA, alongB) < ALIGNED) {
            return false;
        }
        boolean onB = alongB >= alongA - EVEN;
        ContactFeature reference = onB ? ofB : ofA;
        ContactFeature incident = onB ? ofA : ofB;
        incident.clip(reference);
        int corners = choose(reference, incident);
        double sign = onB ? 1 : -1;
        for (int i = 0; i < corners; i++) {
            int corner = chosen[i];
            double height = reference.height(incident.x(corner), incident.y(corner), incident.z(corner));
            double down = onB ? height : 0;
            into.add(sign * reference.nx, sign * reference.ny, sign * reference.nz, incident.x(corner) - down * reference.nx,
                incident.y(corner) - down * reference.ny, incident.z(corner) - down * reference.nz, height);
        }
        return corners > 0;
    }

    /** The lowest corner, the one farthest from it, and those farthest from their line to either side. */
    private int choose(ContactFeature reference, ContactFeature incident) {
        int lowest = -1;
        double least = reach;
        for (int i = 0; i < incident.count; i++) {
            double height = reference.height(incident.x(i), incident.y(i), incident.z(i));
            if (height < least) {
                least = height;
                lowest = i;
            }
        }
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
                if (area > most + SKIN * SKIN && reference.height(incident.x(i), incident.y(i), incident.z(i)) < reach) {
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

    private static double square(double value) {
        return value * value;
    }

    /** Twice the area of a triangle of corners, + counter-clockwise seen from above the face. */
    private static double area(ContactFeature reference, ContactFeature incident, int a, int b, int c) {
        double ux = incident.x(b) - incident.x(a);
        double uy = incident.y(b) - incident.y(a);
        double uz = incident.z(b) - incident.z(a);
        double vx = incident.x(c) - incident.x(a);
        double vy = incident.y(c) - incident.y(a);
        double vz = incident.z(c) - incident.z(a);
        return reference.nx * (uy * vz - uz * vy) + reference.ny * (uz * vx - ux * vz) + reference.nz * (ux * vy - uy * vx);
    }
}
