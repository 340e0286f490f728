// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.ArrayList;
import java.util.List;

/**
 * Filters ghost collisions at internal edges of a mesh, so that bodies slide and roll over them smoothly. To a body on
 * one triangle the next triangle presents its edge, which would act as a wall. Face contacts are therefore processed
 * first. An edge or corner contact on a triangle already in contact adds no contact of its own. If its triangle rises
 * from there, the contact gets the triangle's normal. One solid at a time; not thread-safe.
 */
public final class InnerEdges {
    /** Smallest cosine between contact normal and triangle normal of a face contact. */
    private static final double FACE = 1 - 1e-6;
    /** Distance at which a point is on a triangle, metres. */
    private static final double ON = 1e-4;
    /** Height of a corner above another triangle from which a triangle rises, metres. */
    private static final double RISES = 1e-6;

    private final List<Touch> kept = new ArrayList<>();
    /** Triangles with a face contact, and those that an internal edge connects to them. */
    private final List<Touch> faces = new ArrayList<>();
    private final List<Touch> edges = new ArrayList<>();
    private int used;

    /** Contact of a triangle. */
    private static final class Touch {
        final ContactTriangle triangle = new ContactTriangle();
        final double[] p = new double[3];
        double nx;
        double ny;
        double nz;
        double distance;
        /** Whether its plane is in contact. */
        boolean supports;

        /** Compares distances, and at equal distances corners: the order of the search does not count. */
        boolean isBefore(Touch other) {
            return distance < other.distance || distance == other.distance && triangle.compare(other.triangle) < 0;
        }
    }

    public void clear() {
        faces.clear();
        edges.clear();
        used = 0;
    }

    private Touch take(ContactTriangle triangle) {
        if (used == kept.size()) {
            kept.add(new Touch());
        }
        Touch touch = kept.get(used++);
        touch.triangle.copy(triangle);
        touch.supports = false;
        return touch;
    }

    /** Whether the contact with a triangle is a face contact. */
    public static boolean isFace(ContactTriangle triangle, GjkDistance nearest) {
        return Math.abs(triangle.cosine(nearest.nx, nearest.ny, nearest.nz)) > FACE;
    }

    /** Adds a triangle with a face contact. */
    public void addFace(ContactTriangle triangle) {
        Touch touch = take(triangle);
        touch.supports = true;
        faces.add(touch);
    }

    /** Adds a triangle with an edge or corner contact. */
    public void addEdge(ContactTriangle triangle, GjkDistance nearest) {
        Touch touch = take(triangle);
        System.arraycopy(nearest.onB, 0, touch.p, 0, 3);
        touch.nx = nearest.nx;
        touch.ny = nearest.ny;
        touch.nz = nearest.nz;
        touch.distance = nearest.distance;
        int at = edges.size();
        edges.add(touch);
        for (; at > 0 && touch.isBefore(edges.get(at - 1)); at--) {
            edges.set(at, edges.get(at - 1));
        }
        edges.set(at, touch);
    }

    /** Number of triangles with an edge or corner contact. */
    public int size() {
        return edges.size();
    }

    /** Triangle with an edge or corner contact, in order of distance. */
    public ContactTriangle get(int i) {
        return edges.get(i).triangle;
    }

    /**
     * Whether an edge contact is at an internal edge; adds a contact if the triangle rises from all triangles there
     * whose planes are in contact. A triangle behind one that falls away adds none: its plane would lie above the body.
     * @param ball radius of the body if it is a ball, metres, else 0
     */
    public boolean isInner(int edge, double ball, ContactPoints into) {
        Touch touch = edges.get(edge);
        boolean inner = false;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < faces.size(); i++) {
            Touch face = faces.get(i);
            if (face.triangle.holds(touch.p, ON)) {
                inner = true;
                if (face.supports) {
                    least = Math.min(least, touch.triangle.rise(face.triangle, touch.nx, touch.ny, touch.nz));
                }
            }
        }
        if (inner) {
            faces.add(touch);
            touch.supports = least > RISES && least < Double.POSITIVE_INFINITY;
        }
        if (touch.supports) {
            touch.triangle.addPlane(touch.p, touch.nx, touch.ny, touch.nz, touch.distance, ball, into);
        }
        return inner;
    }
}
