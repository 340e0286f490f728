// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Triangles;
import org.SEAR.geometry.VolumeIntegrals;

/**
 * Volume that a triangle mesh encloses. A mesh is closed if each edge is used as often in one direction as in the
 * other. Vertices at the same place, up to rounding, count as one. A part that is inside out, such as a mirrored one,
 * counts as solid unless another part's box surrounds it: then it is a cavity. Overlapping parts count twice where they
 * overlap.
 */
final class ClosedMesh {
    private final double[] points;
    /** Three vertex numbers per triangle; vertices at the same place share the number. */
    private final int[] corners;
    /** Union-find forest of the vertices: one tree per connected part. */
    private final int[] parents;

    /** Connected triangles. */
    private static final class Part {
        private final Aabb box = new Aabb();
        private final VolumeIntegrals integrals;

        Part(double[] points) {
            integrals = new VolumeIntegrals(points[0], points[1], points[2]);
        }

        void add(double[] points, int a, int b, int c) {
            integrals.add(points, 3 * a, 3 * b, 3 * c);
            for (int corner : new int[] {a, b, c}) {
                box.add(points[3 * corner], points[3 * corner + 1], points[3 * corner + 2]);
            }
        }

        boolean isIn(Part other) {
            return other != this && other.box.contains(box) && !box.contains(other.box);
        }
    }

    private ClosedMesh(Triangles mesh, double[] points) {
        this.points = points;
        corners = new int[mesh.indices.length];
        parents = new int[points.length / 3];
        Arrays.setAll(parents, i -> i);
        int[] first = NearPoints.first(points);
        for (int i = 0; i < corners.length; i++) {
            corners[i] = first[mesh.indices[i]];
        }
    }

    /**
     * Returns the integrals over the enclosed volume, which is positive.
     * @param points x, y, z of each vertex of the mesh, scaled, metres
     * @return null if the mesh is open or encloses nothing
     */
    static VolumeIntegrals integrate(Triangles mesh, double[] points) {
        return mesh.size() == 0 ? null : new ClosedMesh(mesh, points).integrate();
    }

    /**
     * Whether a closed mesh encloses a point: the solid angles of its triangles add up to a sphere (Van Oosterom and
     * Strackee 1983, "The solid angle of a plane triangle").
     */
    static boolean encloses(double[] points, int[] corners, double x, double y, double z) {
        double sum = 0;
        for (int i = 0; i < corners.length; i += 3) {
            double[] a = from(points, corners[i], x, y, z);
            double[] b = from(points, corners[i + 1], x, y, z);
            double[] c = from(points, corners[i + 2], x, y, z);
            double triple = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]);
            sum += 2 * Math.atan2(triple, a[3] * b[3] * c[3] + dot(a, b) * c[3] + dot(b, c) * a[3] + dot(c, a) * b[3]);
        }
        return Math.abs(sum) > 2 * Math.PI;
    }

    /** Returns the vector to a vertex and its length. */
    private static double[] from(double[] points, int vertex, double x, double y, double z) {
        double[] v = {points[3 * vertex] - x, points[3 * vertex + 1] - y, points[3 * vertex + 2] - z, 0};
        v[3] = Math.sqrt(dot(v, v));
        return v;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private VolumeIntegrals integrate() {
        if (!isClosed()) {
            return null;
        }
        VolumeIntegrals sum = new VolumeIntegrals(points[0], points[1], points[2]);
        List<Part> parts = parts();
        for (Part part : parts) {
            boolean cavity = part.integrals.volume() < 0 && parts.stream().anyMatch(part::isIn);
            sum.add(part.integrals, part.integrals.volume() < 0 && !cavity ? -1 : 1);
        }
        return sum.volume() > 0 ? sum : null;
    }

    private boolean isClosed() {
        Map<Long, Integer> balance = new HashMap<>();
        for (int i = 0; i < corners.length; i += 3) {
            for (int k = 0; k < 3; k++) {
                int from = corners[i + k];
                int to = corners[i + (k + 1) % 3];
                if (from != to) {
                    balance.merge((long) Math.min(from, to) << 32 | Math.max(from, to), from < to ? 1 : -1,
                        Integer::sum);
                }
            }
        }
        return balance.values().stream().allMatch(count -> count == 0);
    }

    private List<Part> parts() {
        for (int i = 0; i < corners.length; i += 3) {
            parents[root(corners[i])] = root(corners[i + 1]);
            parents[root(corners[i + 1])] = root(corners[i + 2]);
        }
        Map<Integer, Part> parts = new LinkedHashMap<>();
        for (int i = 0; i < corners.length; i += 3) {
            parts.computeIfAbsent(root(corners[i]), root -> new Part(points)).add(points, corners[i], corners[i + 1],
                corners[i + 2]);
        }
        return new ArrayList<>(parts.values());
    }

    private int root(int vertex) {
        int at = vertex;
        while (parents[at] != at) {
            parents[at] = parents[parents[at]];
            at = parents[at];
        }
        return at;
    }
}
