package org.SEAR.raycast.solid;

import java.util.Map;
import java.util.WeakHashMap;
import org.SEAR.geometry.Triangles;
import org.SEAR.raycast.tree.Bvh;
import org.SEAR.raycast.tree.BvhBuilder;

/**
 * Triangles in the order of their hierarchy, in the model's own unscaled frame: 40 bytes a triangle for the corners and its number, about as many for
 * the nodes, and 17 for the patches. Immutable, any thread. The same {@link Triangles} share one mesh as long as somebody holds them.
 */
public final class Mesh {
    private static final int LEAF_SIZE = 4;
    private static final Map<Triangles, Mesh> KNOWN = new WeakHashMap<>();

    /** Its leaves link to triangles. */
    public final Bvh tree;
    /** Nine floats a triangle, in the order of the tree: x, y, z of its three corners. */
    public final float[] corners;
    /** The number that each had before. */
    public final int[] order;
    /** The same triangles as a fan looks at them. */
    public final Patches patches;

    /** Bounds are rounded outward: the slab test leaves out a beam that runs within a box's side, so none may. */
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

    /** The mesh of these triangles, built when it is asked for the first time. */
    public static Mesh of(Triangles triangles) {
        synchronized (KNOWN) {
            return KNOWN.computeIfAbsent(triangles, Mesh::new);
        }
    }
}
