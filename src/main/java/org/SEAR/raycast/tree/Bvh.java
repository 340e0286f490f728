// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.tree;

/**
 * Bounding volume hierarchy in one flat array. The two children of a node are adjacent in memory, so one access fetches
 * both. Bounds may be refitted; the topology never changes. Any thread may read it while no thread refits.
 */
public final class Bvh {
    /** Maximum path length from the root to a leaf; the size of traversal stacks. */
    public static final int MAX_DEPTH = 96;
    /** Floats per node in {@link #data}: minimum x, y, z, maximum x, y, z, and the bits of two integers. */
    public static final int STRIDE = 8;
    /** Floats of a node's bounds. */
    public static final int BOUNDS = 6;
    public static final int LINK = 6;
    public static final int COUNT = 7;

    public final float[] data;
    /** Item numbers, leaf by leaf. */
    public final int[] items;

    public Bvh(float[] data, int[] items) {
        this.data = data;
        this.items = items;
    }

    /** Returns the number of nodes including the root, node 0; 0 without items. Node 1 is never used. */
    public int size() {
        return data.length / STRIDE;
    }

    /**
     * Inner node: returns the number of the left child; the right child follows it. Leaf: returns the index of its
     * first item in {@link #items}.
     */
    public int link(int node) {
        return Float.floatToRawIntBits(data[node * STRIDE + LINK]);
    }

    /** Returns the number of items of a leaf, 0 for an inner node. */
    public int count(int node) {
        return Float.floatToRawIntBits(data[node * STRIDE + COUNT]);
    }

    public static void describe(float[] data, int node, int link, int count) {
        data[node * STRIDE + LINK] = Float.intBitsToFloat(link);
        data[node * STRIDE + COUNT] = Float.intBitsToFloat(count);
    }

    /**
     * Recomputes the bounds of an inner node from its children.
     *
     * @return whether they changed
     */
    public boolean refit(int node) {
        int at = node * STRIDE;
        int left = link(node) * STRIDE;
        boolean changed = false;
        for (int k = 0; k < BOUNDS; k++) {
            float a = data[left + k];
            float b = data[left + STRIDE + k];
            float value = k < 3 ? Math.min(a, b) : Math.max(a, b);
            changed |= value != data[at + k];
            data[at + k] = value;
        }
        return changed;
    }

    /** Returns the greatest absolute coordinate of any item along an axis, metres. */
    public double farthest(int axis) {
        return data.length == 0 ? 0 : Math.max(Math.abs(data[axis]), Math.abs(data[axis + 3]));
    }

    /** Returns half the surface area of a node's bounds, m^2. */
    public double halfArea(int node) {
        return halfArea(data, node * STRIDE);
    }

    public static double halfArea(float[] box, int at) {
        double x = (double) box[at + 3] - box[at];
        double y = (double) box[at + 4] - box[at + 1];
        double z = (double) box[at + 5] - box[at + 2];
        return x * y + y * z + z * x;
    }
}
