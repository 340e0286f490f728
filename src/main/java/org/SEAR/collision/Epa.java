// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.ArrayList;
import java.util.List;

/**
 * Penetration depth of two convex sets by the expanding polytope algorithm (van den Bergen, "Proximity queries and
 * penetration depth computation on 3D game objects", 2001).
 *
 * <p>If the sets overlap, their Minkowski difference contains the origin, and the minimum translation leads to its
 * nearest face. A polytope of support points inside it grows. Each iteration adds the support point in the direction of
 * the face nearest to the origin. It replaces the faces that this point sees, until the nearest face moves no further.
 *
 * <p>Accurate to 2e-6 m between flat faces, and to about 2 mm between curved surfaces of a metre, where
 * {@link #ITERATIONS} end the search; the error grows with the depth. Overlaps last a step or two, so speed matters
 * little.
 */
final class Epa {
    /** Accuracy at which the search ends, metres. */
    private static final double PRECISION = 1e-6;
    private static final double NOTHING = 1e-12;
    private static final int ITERATIONS = 96;
    private static final double[][] AXES = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};

    private final List<Corner> corners = new ArrayList<>();
    private final List<Face> faces = new ArrayList<>();
    private final List<Corner[]> rim = new ArrayList<>();

    /** Point of the Minkowski difference, and its support point on the second set. */
    private static final class Corner {
        final double[] at = new double[3];
        final double[] onB = new double[3];
    }

    private static final class Face {
        final Corner a;
        final Corner b;
        final Corner c;
        final double[] normal;
        /** Distance of the plane from the origin, positive if the origin is inside. */
        final double distance;

        /** @param inside a point that the normal faces away from */
        Face(Corner a, Corner b, Corner c, double[] inside) {
            double[] cross = cross(a.at, b.at, c.at);
            double length = Math.sqrt(dot(cross, cross));
            double out = cross[0] * (a.at[0] - inside[0]) + cross[1] * (a.at[1] - inside[1])
                + cross[2] * (a.at[2] - inside[2]);
            boolean turned = out < 0;
            this.a = a;
            this.b = turned ? c : b;
            this.c = turned ? b : c;
            double scale = (turned ? -1 : 1) / Math.max(length, Double.MIN_NORMAL);
            normal = new double[] {cross[0] * scale, cross[1] * scale, cross[2] * scale};
            distance = length > NOTHING ? dot(normal, a.at) : Double.POSITIVE_INFINITY;
        }
    }

    /**
     * Measures the depth.
     * @param p corners of the simplex at the end of the distance search
     * @param q their support points on the second set
     * @param into takes the result
     * @return false if both sets together are flat
     */
    boolean measure(Convex first, Convex second, double[][] p, double[][] q, int size, GjkDistance into) {
        corners.clear();
        faces.clear();
        for (int i = 0; i < size; i++) {
            Corner corner = new Corner();
            System.arraycopy(p[i], 0, corner.at, 0, 3);
            System.arraycopy(q[i], 0, corner.onB, 0, 3);
            corners.add(corner);
        }
        if (!fill(first, second)) {
            return false;
        }
        double[] inside = new double[3];
        for (int i = 0; i < 4; i++) {
            for (int axis = 0; axis < 3; axis++) {
                inside[axis] += corners.get(i).at[axis] / 4;
            }
        }
        addFace(0, 1, 2, inside);
        addFace(0, 1, 3, inside);
        addFace(0, 2, 3, inside);
        addFace(1, 2, 3, inside);
        Face nearest = nearest();
        for (int iteration = 0; iteration < ITERATIONS; iteration++) {
            Corner far = corner(first, second, nearest.normal);
            if (dot(nearest.normal, far.at) - nearest.distance <= PRECISION || !grow(far, inside)) {
                break;
            }
            nearest = nearest();
        }
        answer(nearest, into);
        return true;
    }

    private void addFace(int a, int b, int c, double[] inside) {
        faces.add(new Face(corners.get(a), corners.get(b), corners.get(c), inside));
    }

    private static Corner corner(Convex first, Convex second, double[] direction) {
        Corner corner = new Corner();
        GjkDistance.minkowskiDifference(first, second, direction[0], direction[1], direction[2], corner.at, corner.onB);
        return corner;
    }

    /**
     * Extends the simplex to a tetrahedron.
     * @return false if both sets together are flat
     */
    private boolean fill(Convex first, Convex second) {
        while (corners.size() < 4) {
            Corner best = null;
            double most = NOTHING;
            for (double[] direction : directions()) {
                Corner corner = corner(first, second, direction);
                double room = room(corner);
                if (room > most) {
                    most = room;
                    best = corner;
                }
            }
            if (best == null) {
                return false;
            }
            corners.add(best);
        }
        return true;
    }

    private double[][] directions() {
        if (corners.size() < 3) {
            return AXES;
        }
        double[] n = cross(corners.get(0).at, corners.get(1).at, corners.get(2).at);
        return new double[][] {n, {-n[0], -n[1], -n[2]}};
    }

    /** Returns the gain by a corner: a squared length, a squared area, or a volume. */
    private double room(Corner corner) {
        double[] a = corners.get(0).at;
        double[] d = {corner.at[0] - a[0], corner.at[1] - a[1], corner.at[2] - a[2]};
        if (corners.size() == 1) {
            return dot(d, d);
        }
        double[] n = cross(a, corners.get(1).at, corners.size() == 2 ? corner.at : corners.get(2).at);
        return corners.size() == 2 ? dot(n, n) : Math.abs(dot(n, d));
    }

    private Face nearest() {
        Face nearest = faces.get(0);
        for (Face face : faces) {
            if (face.distance < nearest.distance) {
                nearest = face;
            }
        }
        return nearest;
    }

    /**
     * Adds a corner and replaces the faces that it sees.
     * @return false if it sees none
     */
    private boolean grow(Corner far, double[] inside) {
        rim.clear();
        int kept = 0;
        for (int i = 0; i < faces.size(); i++) {
            Face face = faces.get(i);
            if (dot(face.normal, far.at) - dot(face.normal, face.a.at) > NOTHING) {
                toggle(face.a, face.b);
                toggle(face.b, face.c);
                toggle(face.c, face.a);
            } else {
                faces.set(kept++, face);
            }
        }
        if (rim.size() < 3) {
            return false;
        }
        faces.subList(kept, faces.size()).clear();
        for (Corner[] edge : rim) {
            faces.add(new Face(edge[0], edge[1], far, inside));
        }
        return true;
    }

    private void toggle(Corner from, Corner to) {
        for (int i = 0; i < rim.size(); i++) {
            if (rim.get(i)[0] == to && rim.get(i)[1] == from) {
                rim.remove(i);
                return;
            }
        }
        rim.add(new Corner[] {from, to});
    }

    /** Computes the contact point from the origin's projection on the face, by barycentric coordinates. */
    private static void answer(Face face, GjkDistance into) {
        double[] foot = {face.normal[0] * face.distance, face.normal[1] * face.distance,
            face.normal[2] * face.distance};
        double whole = Math.sqrt(square(cross(face.a.at, face.b.at, face.c.at)));
        double u = Math.sqrt(square(cross(foot, face.b.at, face.c.at))) / whole;
        double v = Math.sqrt(square(cross(foot, face.c.at, face.a.at))) / whole;
        double w = Math.max(0, 1 - u - v);
        for (int axis = 0; axis < 3; axis++) {
            into.onB[axis] = (u * face.a.onB[axis] + v * face.b.onB[axis] + w * face.c.onB[axis]) / (u + v + w);
        }
        into.nx = -face.normal[0];
        into.ny = -face.normal[1];
        into.nz = -face.normal[2];
        into.distance = -face.distance;
    }

    private static double[] cross(double[] a, double[] b, double[] c) {
        double ux = b[0] - a[0];
        double uy = b[1] - a[1];
        double uz = b[2] - a[2];
        double wx = c[0] - a[0];
        double wy = c[1] - a[1];
        double wz = c[2] - a[2];
        return new double[] {uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx};
    }

    private static double square(double[] of) {
        return dot(of, of);
    }

    private static double dot(double[] u, double[] w) {
        return u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
    }
}
