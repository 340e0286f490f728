// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import com.bulletphysics.collision.shapes.TriangleCallback;
import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Vector3f;
import org.SEAR.collision.ContactPoints;
import org.SEAR.collision.ContactTriangle;
import org.SEAR.collision.Convex;
import org.SEAR.collision.SegmentTriangleSweep;
import org.SEAR.collision.GjkDistance;
import org.SEAR.collision.InnerEdges;
import org.SEAR.collision.ManifoldClipper;
import org.SEAR.collision.SupportPoints;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Placement;

/** Finds contacts of bodies from their exact shapes in double precision. Simulation thread. */
final class NarrowPhase {
    /**
     * A former separating direction of two flat solids is kept if its distance is within this of the best, metres;
     * otherwise the contact would flicker.
     */
    private static final double CHANGE = 1e-4;
    /** Largest gap of a contact point of a body that moves fast, metres: it grows with the speed. */
    private static final double FAST = 0.01;
    /** Distance at which a body stops before a triangle, as a share of the substep's path. */
    private static final double BEFORE = 0.01;
    /** Possible contacts above which a body counts as crowded. */
    private static final int MAX_CONTACTS = 48;

    private final GjkDistance gjk = new GjkDistance();
    private final ManifoldClipper clipper = new ManifoldClipper();
    private final ContactPoints contacts = new ContactPoints();
    private final SupportPoints support = new SupportPoints();
    private final ContactTriangle triangle = new ContactTriangle();
    private final InnerEdges inner = new InnerEdges();
    private final SegmentTriangleSweep crossing = new SegmentTriangleSweep();
    private final TriangleCallback crossed = new TriangleCallback() {
        @Override
        public void processTriangle(Vector3f[] corners, int part, int index) {
            crossing.look(corners);
        }
    };
    private final double[] start = new double[3];
    private final double[] end = new double[3];
    private final Vector3f low = new Vector3f();
    private final Vector3f high = new Vector3f();
    private final Aabb box = new Aabb();
    private final List<PairContacts> pairs = new ArrayList<>();
    private final double seconds;
    private double gain;
    private PlacedSolid solid;
    private PlacedSolid mesh;
    private double reach;
    private double margin;
    private boolean near;
    private double clear;
    private PairContacts current;
    private final double[] guess = {1, 0, 0};
    private final double[] load = new double[3];
    private final TriangleCallback triangles = new TriangleCallback() {
        @Override
        public void processTriangle(Vector3f[] corners, int part, int index) {
            intersectTriangle(corners);
        }
    };

    /**
     * @param seconds length of a step
     * @param gravity m/s^2
     */
    NarrowPhase(double seconds, double gravity) {
        this.seconds = seconds;
        setGravity(gravity);
    }

    /** @param gravity m/s^2 */
    void setGravity(double gravity) {
        gain = gravity * seconds;
    }

    /** Length of a step, seconds. */
    double stepSeconds() {
        return seconds;
    }

    /** Speed gained by gravity in a step, m/s. */
    double stepGain() {
        return gain;
    }

    /** Clears the pairs of the last step. */
    void clear() {
        pairs.clear();
    }

    /**
     * Whether both bodies already have so many contacts that their own pair is skipped in this step: this bounds the
     * cost of many bodies inside each other.
     */
    boolean isCrowded(Body a, Body b) {
        return a.countContact() > MAX_CONTACTS && b.countContact() > MAX_CONTACTS;
    }

    /** Adds a pair that has contacts in this step. */
    void list(PairContacts pair) {
        pairs.add(pair);
    }

    /** Pairs with contacts in this step, in a deterministic order. */
    List<PairContacts> getPairs() {
        return pairs;
    }

    /**
     * Finds the contacts of two bodies.
     * @param a not a mesh
     * @param newMargin largest gap of a contact point, metres
     * @param newReach largest distance of interest, metres, at least {@code newMargin}
     * @return whether they come that near
     */
    boolean find(PairContacts pair, Body a, Body b, double newMargin, double newReach) {
        margin = newMargin;
        reach = Math.max(newMargin, newReach);
        near = false;
        clear = Double.POSITIVE_INFINITY;
        current = pair;
        PlacedSolid[] ofA = a.place();
        PlacedSolid[] ofB = b.place();
        for (int i = 0; i < ofA.length; i++) {
            for (int k = 0; k < ofB.length; k++) {
                double apart = ofA[i].gap(ofB[k]);
                if (apart <= reach) {
                    find(pair, ofA[i], i, ofB[k], k);
                } else {
                    clear = Math.min(clear, apart);
                }
            }
        }
        return near;
    }

    /** Smallest distance of solids outside the reach, metres. */
    double getClear() {
        return clear;
    }

    private void find(PairContacts pair, PlacedSolid a, int solidA, PlacedSolid b, int solidB) {
        contacts.clear();
        clipper.setReach(margin);
        boolean touched = pair.guess(guess);
        pair.load(load);
        clipper.setLoad(load);
        if (b.isMesh()) {
            solid = a;
            mesh = b;
            b.inFrame(a, reach, box);
            low.set((float) box.minX, (float) box.minY, (float) box.minZ);
            high.set((float) box.maxX, (float) box.maxY, (float) box.maxZ);
            inner.clear();
            b.getTriangles().find(triangles, low, high);
            double ball = a.shape.isBall() ? a.shape.skin() : 0;
            for (int i = 0; i < inner.size(); i++) {
                if (!inner.isInner(i, ball, contacts) && measure(solid, inner.get(i), inner.get(i), 0)) {
                    touch(inner.get(i));
                }
            }
            clear = Math.min(clear, reach);
        } else {
            double apart = pair.isSingle() ? gjk.gap(a, b, guess) : 0;
            if (apart <= reach) {
                findConvex(pair, a, b, touched);
            } else {
                clear = Math.min(clear, apart);
            }
        }
        write(pair, a, solidA, b, solidB);
    }

    private void findConvex(PairContacts pair, PlacedSolid a, PlacedSolid b, boolean touched) {
        if (pair.testsFaceFirst() && byFace(a, b)) {
            if (isNear()) {
                clipper.find(gjk, contacts);
            }
        } else if (measure(a, b.core(), b, b.shape.skin())) {
            if (touched && pair.isFlat()) {
                gjk.keep(a, b, guess, CHANGE);
            }
            setFeatures(a, b);
            clipper.find(gjk, contacts);
        }
    }

    /**
     * Sets the features along the contact normal. That of a curved side opposite a face is the one along the face's
     * normal: a distance gives the direction only to its square root, which would move the line of a log sideways.
     */
    private void setFeatures(PlacedSolid a, PlacedSolid b) {
        b.feature(gjk.nx, gjk.ny, gjk.nz, clipper.ofB);
        if (clipper.ofB.isAlong(gjk.nx, gjk.ny, gjk.nz)) {
            a.feature(-clipper.ofB.nx, -clipper.ofB.ny, -clipper.ofB.nz, clipper.ofA);
            return;
        }
        a.feature(-gjk.nx, -gjk.ny, -gjk.nz, clipper.ofA);
        if (clipper.ofA.isAlong(-gjk.nx, -gjk.ny, -gjk.nz)) {
            b.feature(-clipper.ofA.nx, -clipper.ofA.ny, -clipper.ofA.nz, clipper.ofB);
        }
    }

    /** Tests whether a face of one of them separates them best, as in most contacts with fixed bodies. */
    private boolean byFace(PlacedSolid a, PlacedSolid b) {
        double skins = a.shape.skin() + b.shape.skin();
        b.feature(guess[0], guess[1], guess[2], clipper.ofB);
        if (gjk.byFace(clipper.ofB, true, a, skins)) {
            a.feature(-gjk.nx, -gjk.ny, -gjk.nz, clipper.ofA);
            return true;
        }
        a.feature(-guess[0], -guess[1], -guess[2], clipper.ofA);
        if (gjk.byFace(clipper.ofA, false, b, skins)) {
            b.feature(gjk.nx, gjk.ny, gjk.nz, clipper.ofB);
            return true;
        }
        return false;
    }

    /**
     * Measures the distance by the cores, which stay apart in ordinary contacts; only penetrations deeper than both
     * convex radii cost more.
     */
    private boolean measure(PlacedSolid a, Convex coreOfB, Convex b, double skinOfB) {
        double skins = a.shape.skin() + skinOfB;
        if (!gjk.measure(a.core(), coreOfB, reach + 2 * skins, guess[0], guess[1], guess[2])) {
            if (!current.isOfMesh()) {
                current.parted(gjk.nx, gjk.ny, gjk.nz);
            }
            clear = Math.min(clear, gjk.distance - 2 * skins);
            return false;
        }
        gjk.addSkins(a, b, skinOfB);
        return isNear();
    }

    /** Notes the distance; returns whether they may touch. */
    private boolean isNear() {
        if (gjk.distance <= reach) {
            near = true;
            current.approached(gjk.distance, gjk.nx, gjk.ny, gjk.nz);
        } else {
            clear = Math.min(clear, gjk.distance);
        }
        return gjk.distance <= margin;
    }

    private void intersectTriangle(Vector3f[] corners) {
        if (!triangle.set(corners, mesh.place) || !triangle.isNear(solid, reach)
            || !measure(solid, triangle, triangle, 0)) {
            return;
        }
        boolean through = gjk.distance < 0 && triangle.depth() <= ManifoldClipper.BREAKING;
        if (through) {
            // a shallow penetration resolves through the triangle's face, not sideways over its edges to the next
            // triangle
            triangle.front(clipper.ofB);
            solid.feature(-clipper.ofB.nx, -clipper.ofB.ny, -clipper.ofB.nz, clipper.ofA);
            if (clipper.faces(clipper.ofB.nx, clipper.ofB.ny, clipper.ofB.nz, contacts)) {
                inner.addFace(triangle);
                return;
            }
        }
        if (InnerEdges.isFace(triangle, gjk)) {
            inner.addFace(triangle);
            touch(triangle);
        } else {
            inner.addEdge(triangle, gjk);
        }
    }

    private void touch(ContactTriangle by) {
        by.feature(gjk.nx, gjk.ny, gjk.nz, clipper.ofB);
        if (clipper.ofB.isAlong(gjk.nx, gjk.ny, gjk.nz)) {
            solid.feature(-clipper.ofB.nx, -clipper.ofB.ny, -clipper.ofB.nz, clipper.ofA);
        } else {
            solid.feature(-gjk.nx, -gjk.ny, -gjk.nz, clipper.ofA);
        }
        clipper.find(gjk, contacts);
    }

    /**
     * Stops a body whose centre of mass passed through a triangle of a mesh in a substep (tunnelling). Contacts resolve
     * only bodies that are not yet through.
     * @param b the mesh
     */
    void stopBefore(Body a, Body b) {
        SolverBody solver = a.getSolver();
        mesh = b.place()[0];
        mesh.place.toFrame(solver.getFrom()[0], solver.getFrom()[1], solver.getFrom()[2], start, 0);
        mesh.place.toFrame(solver.place.x, solver.place.y, solver.place.z, end, 0);
        low.set((float) Math.min(start[0], end[0]), (float) Math.min(start[1], end[1]),
            (float) Math.min(start[2], end[2]));
        high.set((float) Math.max(start[0], end[0]), (float) Math.max(start[1], end[1]),
            (float) Math.max(start[2], end[2]));
        crossing.begin(start, end);
        mesh.getTriangles().find(crossed, low, high);
        if (crossing.getShare() < 1) {
            double[] n = crossing.getNormal();
            Placement at = mesh.place;
            solver.stopAt(Math.max(0, crossing.getShare() - BEFORE), at.m00 * n[0] + at.m01 * n[1] + at.m02 * n[2],
                at.m10 * n[0] + at.m11 * n[1] + at.m12 * n[2], at.m20 * n[0] + at.m21 * n[1] + at.m22 * n[2]);
        }
    }

    /** Writes the points to manifolds of one normal each; those with a mesh are too many. */
    private void write(PairContacts pair, PlacedSolid a, int solidA, PlacedSolid b, int solidB) {
        int first = pair.size();
        if (!b.isMesh()) {
            Manifold into = contacts.size() > 0 ? add(pair, a, solidA, b, solidB, 0) : null;
            for (int i = 0; i < contacts.size(); i++) {
                write(i, into);
            }
        } else {
            support.choose(contacts, a.shape.isBall(), margin > FAST);
            for (int k = 0; k < support.size(); k++) {
                Manifold into = add(pair, a, solidA, b, solidB, support.getNormal(k));
                for (int i = 0; i < support.size(k); i++) {
                    write(support.get(k, i), into);
                }
            }
        }
        pair.inherit(first);
    }

    /** Adds a manifold with the normal of a point. */
    private Manifold add(PairContacts pair, PlacedSolid a, int solidA, PlacedSolid b, int solidB, int point) {
        Manifold manifold = pair.add(solidA, solidB);
        manifold.nx = contacts.nx(point);
        manifold.ny = contacts.ny(point);
        manifold.nz = contacts.nz(point);
        // each triangle of a mesh has only a part of the base
        manifold.setLoad(clipper.isByLoad() ? load : null, b.isMesh() ? null : clipper.getMiddle());
        manifold.setSurfaces(a.solid.getSurface(), b.solid.getSurface());
        return manifold;
    }

    private void write(int point, Manifold into) {
        into.add(contacts.x(point), contacts.y(point), contacts.z(point), contacts.height(point));
    }
}
