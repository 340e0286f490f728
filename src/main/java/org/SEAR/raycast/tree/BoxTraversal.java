// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.tree;

import org.SEAR.geometry.Aabb;

/** Traverses the leaves of a {@link Bvh} that overlap a box. One thread. */
public final class BoxTraversal {
    private final int[] stack = new int[Bvh.MAX_DEPTH];
    private int depth;
    private long nodes;
    private Bvh tree;
    private Aabb box;

    /** Begins a traversal. The box must not change before its end. */
    public void start(Bvh newTree, Aabb newBox) {
        tree = newTree;
        box = newBox;
        depth = 0;
        if (tree.size() > 0) {
            stack[depth++] = 0;
        }
    }

    /** Returns the next leaf whose bounds overlap the box, or -1. */
    public int next() {
        while (depth > 0) {
            int node = stack[--depth];
            nodes++;
            if (overlaps(node)) {
                if (tree.count(node) > 0) {
                    return node;
                }
                stack[depth++] = tree.link(node) + 1;
                stack[depth++] = tree.link(node);
            }
        }
        return -1;
    }

    /** Returns the number of nodes visited so far. */
    public long getNodes() {
        return nodes;
    }

    private boolean overlaps(int node) {
        float[] data = tree.data;
        int at = node * Bvh.STRIDE;
        return data[at] <= box.maxX && data[at + 3] >= box.minX && data[at + 1] <= box.maxY && data[at + 4] >= box.minY
            && data[at + 2] <= box.maxZ && data[at + 5] >= box.minZ;
    }
}
