package org.SEAR.collision;

/**
 * Where two sets touch. {@link Closest} gives one point and a direction; here what both turn to each other is cut to the part that they share, and
 * its outermost corners are the contact, all in the same step. So things stand still. Where no face is part of it (edge on edge), the one point
 * stands.
 */
public final class Patch {
    /** Surfaces this close already carry each other, metres: a face that rests has all its corners in touch. */
    public static final float SKIN = 5e-4f;
    /** Surfaces farther apart than this have no contact, metres; jbullet's own limit. */
    public static final float BREAKING = 0.02f;
    /** A face whose normal has at least this cosine to the direction of the contact is part of it (6 degrees). */
    private static final double ALIGNED = 0.995;
    /** Faces of both are equally good within this. */
    private static final double EVEN = 1e-3;
    private static final int CORNERS = 4;

    /** What each turns to the other, in the world; filled in by the caller. */
    public final Feature ofA = new Feature();
    public final Feature ofB = new Feature();
    private final int[] chosen = new int[CORNERS];

    /** Adds the points of contact. @param nearest from B to A */
    public void find(Closest nearest, Contacts into) {
        if (!faces(nearest.nx, nearest.ny, nearest.nz, into)) {
            into.add(nearest.nx, nearest.ny, nearest.nz, nearest.onB[0], nearest.onB[1], nearest.onB[2], nearest.distance);
        }
    }

    /** Adds the corners of what both share. @param nx direction from B to A @return whether there is such a patch */
    public boolean faces(double nx, double ny, double nz, Contacts into) {
        double alongA = ofA.flat ? -(nx * ofA.nx + ny * ofA.ny + nz * ofA.nz) : 0;
        double alongB = ofB.flat ? nx * ofB.nx + ny * ofB.ny + nz * ofB.nz : 0;
        if (Math.max(alongA, alongB) < ALIGNED) {
            return false;
        }
        boolean onB = alongB >= alongA - EVEN;
        Feature face = onB ? ofB : ofA;
        Feature cut = onB ? ofA : ofB;
        cut.clip(face);
        int corners = choose(face, cut);
        double sign = onB ? 1 : -1;
        for (int i = 0; i < corners; i++) {
            int corner = chosen[i];
            double height = face.height(cut.x(corner), cut.y(corner), cut.z(corner));
            double down = onB ? height : 0;
            into.add(sign * face.nx, sign * face.ny, sign * face.nz, cut.x(corner) - down * face.nx, cut.y(corner) - down * face.ny,
                cut.z(corner) - down * face.nz, height);
        }
        return corners > 0;
    }

    /** The lowest corner, the one farthest from it, and those farthest from their line to either side. */
    private int choose(Feature face, Feature cut) {
        int lowest = -1;
        double least = BREAKING;
        for (int i = 0; i < cut.count; i++) {
            double height = face.height(cut.x(i), cut.y(i), cut.z(i));
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
        for (int i = 0; i < cut.count; i++) {
            double distance = square(cut.x(i) - cut.x(lowest)) + square(cut.y(i) - cut.y(lowest)) + square(cut.z(i) - cut.z(lowest));
            if (distance > most && face.height(cut.x(i), cut.y(i), cut.z(i)) < BREAKING) {
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
            for (int i = 0; i < cut.count; i++) {
                double area = side * area(face, cut, lowest, far, i);
                if (area > most + SKIN * SKIN && face.height(cut.x(i), cut.y(i), cut.z(i)) < BREAKING) {
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
    private static double area(Feature face, Feature cut, int a, int b, int c) {
        double ux = cut.x(b) - cut.x(a);
        double uy = cut.y(b) - cut.y(a);
        double uz = cut.z(b) - cut.z(a);
        double vx = cut.x(c) - cut.x(a);
        double vy = cut.y(c) - cut.y(a);
        double vz = cut.z(c) - cut.z(a);
        return face.nx * (uy * vz - uz * vy) + face.ny * (uz * vx - ux * vz) + face.nz * (ux * vy - uy * vx);
    }
}
