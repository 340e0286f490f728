// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

import java.util.Map;
import java.util.WeakHashMap;
import org.SEAR.geometry.Triangles;
import org.SEAR.raycast.tree.Bvh;
import org.SEAR.raycast.tree.BvhBuilder;

/**
 * Triangles in the order of their hierarchy, in the model's own unscaled frame. Memory per triangle: 40 bytes for the
 * corners and its number, about as many for the nodes, and 17 for the patches. All users of the same {@link Triangles}
 * share one mesh through a weak cache. Immutable, any thread.
 */
public final class Mesh {
    private static final int LEAF_SIZE = 4;
    private static final Map<Triangles, Mesh> KNOWN = new WeakHashMap<>();

    /** Its leaves contain triangles. */
    public final Bvh tree;
    /** Corners, nine floats per triangle: x, y and z of three corners, in tree order. */
    public final float[] corners;
    /** Original number of each triangle. */
    public final int[] order;
    /** The same triangles grouped for fans. */
    public final Patches patches;

    /** Builds the hierarchy. Bounds are rounded outward because the slab test misses rays within a box's side. */
    private Mesh(Triangles triangles) {
        int n = triangles.size();
        float[] boxes = new float[n * Bvh.BOUNDS];
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < 3; k++) {
                float a = triangles.vertices[3 * triangles.indices[3 * i] + k];
                float b = triangles.vertices[3 * triangles.indices[3 * i + 1] + k];
                float c = triangles.vertices[3 * triangles.indices[3 * i + 2] + k];
                boxes[i * Bvh.BOUNDS + k] = Math.nextDown(Math.min(a, Math.min(b, c)));
                boxes[i * Bvh.BOUNDS + k + 3] = Math.nextUp(Math.max(a, Math.max(b, c)));
            }
        }
        Bvh built = BvhBuilder.build(boxes, LEAF_SIZE);
        order = built.items;
        corners = new float[9 * n];
        for (int i = 0; i < n; i++) {
            for (int corner = 0; corner < 3; corner++) {
                int vertex = triangles.indices[3 * built.items[i] + corner];
                System.arraycopy(triangles.vertices, 3 * vertex, corners, 9 * i + 3 * corner, 3);
            }
        }
        tree = new Bvh(built.data, new int[0]);
        patches = new Patches(tree, corners);
    }

    /** Returns the mesh of these triangles; builds it at the first call. */
    public static Mesh of(Triangles triangles) {
        synchronized (KNOWN) {
            return KNOWN.computeIfAbsent(triangles, Mesh::new);
        }
    }
}
