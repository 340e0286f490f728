package org.SEAR.collision;

import java.util.ArrayList;
import java.util.List;

/**
 * The edges inside a mesh, over which things slide and roll as if they were not there. To a thing that lies on one triangle the next one shows its
 * edge, which is nearest to it along the ground: taken for itself that edge would be a wall. So what touches a triangle by its face is looked at
 * first; an edge or corner on such a triangle, or on the next one, does not push by itself. If its triangle goes up from there, it pushes along its
 * own normal. One solid at a time; not for several threads.
 */
public final class InnerEdges {
    /** Least cosine of the direction of a contact to a triangle's normal: it touches by its face. */
    private static final double FACE = 1 - 1e-6;
    /** What is this near to a triangle is on it, metres. */
    private static final double ON = 1e-4;

    private final List<Touch> kept = new ArrayList<>();
    private final List<ContactTriangle> faces = new ArrayList<>();
    private final List<Touch> edges = new ArrayList<>();
    private int used;

    /** A triangle and how something touches it. */
    private static final class Touch {
        final ContactTriangle triangle = new ContactTriangle();
        final double[] p = new double[3];
        double nx;
        double ny;
        double nz;
        double distance;
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
        return touch;
    }

    /** Whether a thing touches a triangle by its face. */
    public static boolean isFace(ContactTriangle triangle, GjkDistance nearest) {
        return Math.abs(triangle.cosine(nearest.nx, nearest.ny, nearest.nz)) > FACE;
    }

    /** Takes a triangle that is touched by its face. */
    public void addFace(ContactTriangle triangle) {
        faces.add(take(triangle).triangle);
    }

    /** Takes one that is touched by an edge or a corner. */
    public void addEdge(ContactTriangle triangle, GjkDistance nearest) {
        Touch touch = take(triangle);
        System.arraycopy(nearest.onB, 0, touch.p, 0, 3);
        touch.nx = nearest.nx;
        touch.ny = nearest.ny;
        touch.nz = nearest.nz;
        touch.distance = nearest.distance;
        int at = edges.size();
        edges.add(touch);
        for (; at > 0 && edges.get(at - 1).distance > touch.distance; at--) {
            edges.set(at, edges.get(at - 1));
        }
        edges.set(at, touch);
    }

    /** How many triangles are touched by an edge or a corner. */
    public int size() {
        return edges.size();
    }

    /** A triangle that is touched by an edge or a corner, the nearest first. */
    public ContactTriangle get(int i) {
        return edges.get(i).triangle;
    }

    /**
     * Whether the edge by which a triangle is touched is one inside the mesh, on what carries; adds the contact if the triangle goes up from there.
     */
    public boolean isInner(int edge, ContactPoints into) {
        Touch touch = edges.get(edge);
        for (int i = 0; i < faces.size(); i++) {
            ContactTriangle face = faces.get(i);
            if (face.holds(touch.p, ON)) {
                if (touch.triangle.rise(face, touch.nx, touch.ny, touch.nz) > ON) {
                    touch.triangle.addPlane(touch.p, touch.nx * touch.distance, touch.ny * touch.distance, touch.nz * touch.distance, into);
                }
                faces.add(touch.triangle);
                return true;
            }
        }
        return false;
    }
}
