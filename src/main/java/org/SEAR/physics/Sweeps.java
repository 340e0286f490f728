package org.SEAR.physics;

import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.shapes.CollisionShape;
import com.bulletphysics.collision.shapes.ConcaveShape;
import com.bulletphysics.collision.shapes.TriangleCallback;
import com.bulletphysics.linearmath.Transform;
import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Vector3f;
import org.SEAR.collision.ContactTriangle;
import org.SEAR.collision.GjkDistance;
import org.SEAR.collision.ManifoldClipper;
import org.SEAR.collision.PlacedConvex;
import org.SEAR.geometry.Placement;
import org.SEAR.physics.solid.Solid;

/**
 * Continuous collision: the pairs of a step of which one moves fast, and where on their ways they would touch. Found by conservative advancement
 * (Mirtich 1996): the distance of two convex sets shrinks no faster than they approach each other along its direction. Simulation thread.
 */
final class Sweeps {
    /** Sets this close have met, metres: then they are in contact. */
    private static final double MET = ManifoldClipper.SKIN / 2;
    /** How exactly the moment is found, metres of the distance: still within what counts as contact. */
    private static final double PRECISION = 2e-4;
    /** Halvings on the way to it along one direction. */
    private static final int HALVINGS = 12;
    private static final int ROUNDS = 48;
    private static final int PASSES = 8;
    /** How deep two that touch may get within a step, as a share of the thinner one's half, and metres. */
    private static final double DEEPEST_SHARE = 0.25;
    private static final double DEEPEST = 0.01;
    /** How much deeper two may get that are deeper already, metres: more than {@link #PRECISION}, else they could not even move out. */
    private static final double DEEPER = 4e-4;
    /** The same in a triangle, which has no other side to come back from. */
    private static final double DEEPER_IN_MESH = 1e-4;

    private final List<Pair> pairs = new ArrayList<>();
    private int count;
    private final GjkDistance gjk = new GjkDistance();
    private final ContactTriangle triangle = new ContactTriangle();
    private final PlacedConvex movedA = new PlacedConvex();
    private final PlacedConvex movedB = new PlacedConvex();
    private final Transform at = new Transform();
    private final Transform inMesh = new Transform();
    private final Transform inWorldOfMesh = new Transform();
    private final Placement placeOfMesh = new Placement();
    private final Vector3f low = new Vector3f();
    private final Vector3f high = new Vector3f();
    private final Vector3f lowThen = new Vector3f();
    private final Vector3f highThen = new Vector3f();
    private final double[] pointA = new double[3];
    private final double[] pointB = new double[3];
    private Pair sought;
    private float earliest;
    private final TriangleCallback triangles = new TriangleCallback() {
        @Override
        public void processTriangle(Vector3f[] corners, int part, int index) {
            if (triangle.set(corners, placeOfMesh) && !staysBeside(sought, earliest)) {
                earliest = meet(sought, triangle, earliest);
            }
        }
    };

    /** Two solids that may meet. */
    private static final class Pair {
        Body a;
        Body b;
        Solid solidA;
        Solid solidB;
        CollisionShape shapeA;
        /** Null if the second is no mesh. */
        ConcaveShape mesh;
        final Transform placeB = new Transform();
        final Transform localA = new Transform();
        final Transform localB = new Transform();
        double nx;
        double ny;
        double nz;
        double distance;
        /** Whether that is their distance, not only the least that it can be. */
        boolean measured;
        /** How deep they may get when they touch, metres. */
        double depth;
        boolean bounces;
        /** How often their bodies had been stopped when the pair was last looked at; nothing is new until that changes. */
        int seen;
    }

    /** Forgets the pairs of the last step. */
    void clear() {
        count = 0;
    }

    /**
     * Adds a pair, with where its solids are now.
     *
     * @param apart what the contacts have found: a direction and the distance that they have at least along it; not for a mesh
     * @param measured whether they have that distance; false for a mesh
     */
    void add(CollisionObject objectA, Solid solidA, Transform placeA, CollisionObject objectB, Solid solidB, Transform placeB, GjkDistance apart,
            boolean measured) {
        if (count == pairs.size()) {
            pairs.add(new Pair());
        }
        Pair pair = pairs.get(count++);
        CollisionShape shapeB = objectB.getCollisionShape();
        pair.a = (Body) objectA.getUserPointer();
        pair.b = (Body) objectB.getUserPointer();
        pair.solidA = solidA;
        pair.solidB = solidB;
        pair.shapeA = objectA.getCollisionShape();
        pair.mesh = shapeB.isConcave() ? (ConcaveShape) shapeB : null;
        pair.placeB.set(placeB);
        pair.seen = -1;
        local(pair.a, placeA, pair.localA);
        local(pair.b, placeB, pair.localB);
        pair.bounces = Math.max(solidA.getSurface().restitution(), solidB.getSurface().restitution()) > 0;
        pair.depth = Math.min(DEEPEST, DEEPEST_SHARE * thinness(pair));
        pair.nx = apart.nx;
        pair.ny = apart.ny;
        pair.nz = apart.nz;
        pair.distance = apart.distance;
        pair.measured = measured;
    }

    /** Where a solid is in the frame of its body's centre of mass, if it is not that itself. */
    private static void local(Body body, Transform place, Transform into) {
        if (body.isCompound()) {
            into.inverse(body.getPlace());
            into.mul(place);
        }
    }

    /** Stops every body where it would touch another, when the ways of the step are planned. */
    void stop() {
        boolean changed = true;
        for (int pass = 0; pass < PASSES && changed; pass++) {
            changed = false;
            for (int i = 0; i < count; i++) {
                changed |= stop(pairs.get(i));
            }
        }
    }

    private boolean stop(Pair pair) {
        int stops = stops(pair);
        if (pair.seen == stops) {
            return false;
        }
        pair.seen = stops;
        Motion a = pair.a.getMotion();
        Motion b = pair.b.getMotion();
        float most = mostEnd(pair);
        if (most == 0 || pair.mesh == null && isClear(pair, most)) {
            return false;
        }
        float share = pair.mesh == null ? meet(pair, null, most) : meetMesh(pair, most);
        if (share >= most) {
            return false;
        }
        boolean stopsA = a != null && share < a.getEnd();
        boolean stopsB = b != null && share < b.getEnd();
        // the one that comes faster stops; the next pass looks whether the other comes, too
        boolean first = stopsA && (!stopsB || approach(pair, a, share, -1) >= approach(pair, b, share, 1));
        (first ? a : b).stop(share, pair.bounces);
        if (mostEnd(pair) <= share) {
            pair.seen = stops(pair);
        }
        return true;
    }

    private static int stops(Pair pair) {
        return (pair.a.getMotion() == null ? 0 : pair.a.getMotion().getStops()) + (pair.b.getMotion() == null ? 0 : pair.b.getMotion().getStops());
    }

    /** The share of the step at which the last of both stops. */
    private static float mostEnd(Pair pair) {
        return Math.max(pair.a.getMotion() == null ? 0 : pair.a.getMotion().getEnd(), pair.b.getMotion() == null ? 0 : pair.b.getMotion().getEnd());
    }

    /** How much of the approach is one body's. */
    private double approach(Pair pair, Motion motion, float share, int sign) {
        return sign * motion.along(gjk.nx, gjk.ny, gjk.nz, share) + motion.turning(null, share);
    }

    /**
     * Whether the direction in which the contacts found them apart parts them all the time: it does at the beginning, and at the end by more than
     * what turning can bend their ways in between.
     */
    private boolean isClear(Pair pair, float most) {
        double target = target(pair, pair.distance);
        if (pair.distance <= target) {
            return false;
        }
        if (pair.distance - closing(pair, pair.nx, pair.ny, pair.nz, 0) > target) {
            return true;
        }
        double then = part(pair, null, most, pair.nx, pair.ny, pair.nz);
        return Math.min(pair.distance, then) - bend(pair) > target;
    }

    /** How near they may come: those that touch have their contacts, which hold a little depth. */
    private static double target(Pair pair, double distance) {
        return distance > ManifoldClipper.SKIN ? MET : Math.min(distance - (pair.mesh == null ? DEEPER : DEEPER_IN_MESH), -pair.depth);
    }

    /** How far turning bends the ways of their points at most, metres. */
    private static double bend(Pair pair) {
        return (pair.a.getMotion() == null ? 0 : pair.a.getMotion().bend()) + (pair.b.getMotion() == null ? 0 : pair.b.getMotion().bend());
    }

    /** Whether the first solid stays on one side of the triangle's plane, but for the depth that contacts hold. */
    private boolean staysBeside(Pair pair, float most) {
        double depth = pair.bounces ? -MET : pair.depth;
        place(pair.a, pair.solidA, pair.localA, 0, movedA);
        triangle.isNear(movedA, 0);
        double above = triangle.getLowest();
        double below = -triangle.getHighest();
        place(pair.a, pair.solidA, pair.localA, most, movedA);
        triangle.isNear(movedA, 0);
        double bend = bend(pair);
        return Math.min(above, triangle.getLowest()) - bend > -depth || Math.min(below, -triangle.getHighest()) - bend > -depth;
    }

    /** How much nearer they may come along a direction in a whole step, from a share of it on, metres. */
    private double closing(Pair pair, double nx, double ny, double nz, float share) {
        Motion a = pair.a.getMotion();
        Motion b = pair.b.getMotion();
        double sum = 0;
        if (a != null) {
            sum += a.turning(pair.a.turningAxis(), share) - a.along(nx, ny, nz, share);
        }
        if (b != null) {
            sum += b.turning(pair.b.turningAxis(), share) + b.along(nx, ny, nz, share);
        }
        return sum;
    }

    private float meetMesh(Pair pair, float most) {
        Body.toPlacement(pair.placeB, placeOfMesh);
        inMesh.inverse(pair.placeB);
        box(pair, 0, low, high);
        box(pair, most, lowThen, highThen);
        float turn = (float) pair.a.getMotion().turning(null, 0) + ManifoldClipper.BREAKING;
        low.set(Math.min(low.x, lowThen.x) - turn, Math.min(low.y, lowThen.y) - turn, Math.min(low.z, lowThen.z) - turn);
        high.set(Math.max(high.x, highThen.x) + turn, Math.max(high.y, highThen.y) + turn, Math.max(high.z, highThen.z) + turn);
        sought = pair;
        earliest = most;
        pair.mesh.processAllTriangles(triangles, low, high);
        return earliest;
    }

    /** The box around the first solid in the mesh's frame after a share of the step. */
    private void box(Pair pair, float share, Vector3f lowest, Vector3f highest) {
        pair.a.getMotion().at(share, at);
        if (pair.a.isCompound()) {
            at.mul(pair.localA);
        }
        inWorldOfMesh.set(inMesh);
        inWorldOfMesh.mul(at);
        pair.shapeA.getAabb(inWorldOfMesh, lowest, highest);
    }

    private void place(Body body, Solid solid, Transform local, float share, PlacedConvex into) {
        if (body.getMotion() == null) {
            at.set(body.getPlace());
        } else {
            body.getMotion().at(share, at);
        }
        if (body.isCompound()) {
            at.mul(local);
        }
        Body.toPlacement(at, into.set(solid.convex()));
    }

    /**
     * @param fixed the triangle met; null for the pair's own second solid
     * @return the share of the step at which they meet, or {@code most}
     */
    private float meet(Pair pair, ContactTriangle fixed, float most) {
        float share = 0;
        double target = MET;
        for (int round = 0; round < ROUNDS; round++) {
            double way = (most - share) * reachOf(pair, share) + 2 * MET;
            if (round == 0 && fixed == null && pair.measured) {
                recall(pair);
            } else {
                place(pair, fixed, share);
                gjk.measure(movedA, fixed == null ? movedB : fixed, way);
            }
            if (gjk.distance > way) {
                return most;
            }
            double distance = gjk.distance;
            if (round == 0) {
                target = target(pair, distance);
            }
            double closing = closing(pair, gjk.nx, gjk.ny, gjk.nz, share);
            float next = nextEnd(pair, share, most);
            if (closing > 0 && distance <= target + PRECISION) {
                return share;
            }
            share = closing <= distance - target ? next : advance(pair, fixed, share, next, (distance - target) / closing, target);
            if (share >= most) {
                return most;
            }
        }
        return share;
    }

    /** Takes over what the contacts have measured. */
    private void recall(Pair pair) {
        gjk.nx = pair.nx;
        gjk.ny = pair.ny;
        gjk.nz = pair.nz;
        gjk.distance = pair.distance;
    }

    private void place(Pair pair, ContactTriangle fixed, float share) {
        place(pair.a, pair.solidA, pair.localA, share, movedA);
        if (fixed == null) {
            place(pair.b, pair.solidB, pair.localB, share, movedB);
        }
    }

    /**
     * As far on as the direction just measured still parts them (bilateral advancement, Catto 2013): to the end, or to where they meet along it;
     * no less than by {@code safe}, as far as the bound of their speeds allows.
     */
    private float advance(Pair pair, ContactTriangle fixed, float share, float next, double safe, double target) {
        double nx = gjk.nx;
        double ny = gjk.ny;
        double nz = gjk.nz;
        if (part(pair, fixed, next, nx, ny, nz) - bend(pair) > target) {
            return next;
        }
        float near = (float) Math.min(next, share + safe);
        float far = next;
        for (int i = 0; i < HALVINGS && far > near; i++) {
            float middle = (near + far) / 2;
            double apart = part(pair, fixed, middle, nx, ny, nz) - target;
            if (apart >= 0) {
                near = middle;
                if (apart < PRECISION / 2) {
                    break;
                }
            } else {
                far = middle;
            }
        }
        return near;
    }

    /** How far a direction parts them after a share of the step. */
    private double part(Pair pair, ContactTriangle fixed, float share, double nx, double ny, double nz) {
        place(pair, fixed, share);
        movedA.support(-nx, -ny, -nz, pointA);
        if (fixed == null) {
            movedB.support(nx, ny, nz, pointB);
        } else {
            fixed.support(nx, ny, nz, pointB);
        }
        return nx * (pointA[0] - pointB[0]) + ny * (pointA[1] - pointB[1]) + nz * (pointA[2] - pointB[2]);
    }

    /** Where the first of the two stops that still moves; until then both move on evenly. */
    private static float nextEnd(Pair pair, float share, float most) {
        float next = most;
        Motion a = pair.a.getMotion();
        Motion b = pair.b.getMotion();
        if (a != null && a.getEnd() > share) {
            next = Math.min(next, a.getEnd());
        }
        if (b != null && b.getEnd() > share) {
            next = Math.min(next, b.getEnd());
        }
        return next;
    }

    /** How far apart they may be at most to meet in a whole step, metres. */
    private double reachOf(Pair pair, float share) {
        Motion a = pair.a.getMotion();
        Motion b = pair.b.getMotion();
        return (a == null ? 0 : a.length(share)) + (b == null ? 0 : b.length(share));
    }

    /** Half of the smaller of the least sizes. */
    private static double thinness(Pair pair) {
        double least = pair.a.isFixed() ? Double.POSITIVE_INFINITY : pair.solidA.convex().least();
        return pair.mesh != null ? least : Math.min(least, pair.solidB.convex().least());
    }
}
