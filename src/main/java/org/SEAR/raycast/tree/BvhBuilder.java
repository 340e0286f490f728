// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.tree;

import java.util.Arrays;

/**
 * Builds a {@link Bvh} top-down with the surface-area heuristic over bins (Wald, "On fast construction of SAH-based
 * bounding volume hierarchies", 2007). The same boxes give the same tree.
 */
public final class BvhBuilder {
    private static final int BINS = 16;
    /** Cost of visiting a node relative to testing an item. */
    private static final double VISIT_COST = 1.5;
    /** Depth from which nodes are halved, so that no path exceeds {@link Bvh#MAX_DEPTH}. */
    private static final int HALVING_DEPTH = Bvh.MAX_DEPTH - 34;
    private static final int STRIDE = Bvh.BOUNDS;

    private final int leafSize;
    private final float[] boxes;
    private final int[] items;
    private float[] data;
    private int nodes;

    private final float[] centres = new float[STRIDE];
    private final float[] binBounds = new float[BINS * STRIDE];
    private final int[] binCount = new int[BINS];
    private final double[] rightCost = new double[BINS];
    private final float[] sweep = new float[STRIDE];
    private int bestAxis;
    private int bestBin;
    private double bestCost;

    private BvhBuilder(float[] boxes, int leafSize) {
        this.boxes = boxes;
        this.leafSize = leafSize;
        int n = boxes.length / STRIDE;
        items = new int[n];
        for (int i = 0; i < n; i++) {
            items[i] = i;
        }
        data = new float[Math.max(2, n) * Bvh.STRIDE];
    }

    /**
     * @param boxes six floats per item: minimum x, y, z, maximum x, y, z; reordered in place to the order of the tree's
     *     items
     * @param leafSize maximum number of items in a leaf
     */
    public static Bvh build(float[] boxes, int leafSize) {
        BvhBuilder builder = new BvhBuilder(boxes, leafSize);
        if (builder.items.length == 0) {
            return new Bvh(new float[0], builder.items);
        }
        builder.nodes = 2;
        builder.split(0, 0, builder.items.length, 0);
        return new Bvh(Arrays.copyOf(builder.data, builder.nodes * Bvh.STRIDE), builder.items);
    }

    private void split(int node, int from, int to, int depth) {
        int at = node * Bvh.STRIDE;
        empty(data, at);
        for (int i = from; i < to; i++) {
            grow(data, at, boxes, i * STRIDE);
        }
        int n = to - from;
        int middle = n <= 1 ? -1 : chooseSplit(node, from, to, depth);
        if (middle < 0) {
            Bvh.describe(data, node, from, n);
            return;
        }
        int children = nodes;
        nodes += 2;
        if (nodes * Bvh.STRIDE > data.length) {
            data = Arrays.copyOf(data, nodes * Bvh.STRIDE * 3 / 2);
        }
        Bvh.describe(data, node, children, 0);
        split(children, from, middle, depth + 1);
        split(children + 1, middle, to, depth + 1);
    }

    /**
     * Partitions the items into two sides.
     * @return index of the right side's first item, or -1 if a leaf is cheaper
     */
    private int chooseSplit(int node, int from, int to, int depth) {
        int n = to - from;
        empty(centres, 0);
        for (int i = from; i < to; i++) {
            for (int k = 0; k < 3; k++) {
                float c = centre(i, k);
                centres[k] = Math.min(centres[k], c);
                centres[k + 3] = Math.max(centres[k + 3], c);
            }
        }
        bestCost = Double.POSITIVE_INFINITY;
        bestAxis = -1;
        for (int axis = 0; axis < 3 && depth < HALVING_DEPTH; axis++) {
            if (centres[axis + 3] > centres[axis]) {
                tryAxis(axis, from, to);
            }
        }
        double whole = Bvh.halfArea(data, node * Bvh.STRIDE);
        if (n <= leafSize && !(VISIT_COST * whole + bestCost < n * whole)) {
            return -1;
        }
        if (bestAxis < 0) {
            return from + n / 2;
        }
        return partition(from, to);
    }

    private void tryAxis(int axis, int from, int to) {
        double low = centres[axis];
        double scale = BINS / ((double) centres[axis + 3] - low);
        for (int b = 0; b < BINS; b++) {
            empty(binBounds, b * STRIDE);
            binCount[b] = 0;
        }
        for (int i = from; i < to; i++) {
            int b = Math.min(BINS - 1, (int) ((centre(i, axis) - low) * scale));
            binCount[b]++;
            grow(binBounds, b * STRIDE, boxes, i * STRIDE);
        }
        empty(sweep, 0);
        int right = 0;
        for (int b = BINS - 1; b > 0; b--) {
            right += binCount[b];
            grow(sweep, 0, binBounds, b * STRIDE);
            rightCost[b] = right == 0 ? Double.POSITIVE_INFINITY : right * Bvh.halfArea(sweep, 0);
        }
        empty(sweep, 0);
        int left = 0;
        for (int b = 0; b < BINS - 1; b++) {
            left += binCount[b];
            grow(sweep, 0, binBounds, b * STRIDE);
            double cost = left == 0 ? Double.POSITIVE_INFINITY : left * Bvh.halfArea(sweep, 0) + rightCost[b + 1];
            if (cost < bestCost) {
                bestCost = cost;
                bestAxis = axis;
                bestBin = b;
            }
        }
    }

    private int partition(int from, int to) {
        double low = centres[bestAxis];
        double scale = BINS / ((double) centres[bestAxis + 3] - low);
        int i = from;
        int j = to - 1;
        while (i <= j) {
            if (Math.min(BINS - 1, (int) ((centre(i, bestAxis) - low) * scale)) <= bestBin) {
                i++;
            } else {
                swap(i, j);
                j--;
            }
        }
        return i;
    }

    private void swap(int i, int j) {
        int item = items[i];
        items[i] = items[j];
        items[j] = item;
        for (int k = 0; k < STRIDE; k++) {
            float f = boxes[i * STRIDE + k];
            boxes[i * STRIDE + k] = boxes[j * STRIDE + k];
            boxes[j * STRIDE + k] = f;
        }
    }

    private float centre(int i, int axis) {
        return 0.5f * boxes[i * STRIDE + axis] + 0.5f * boxes[i * STRIDE + axis + 3];
    }

    private static void empty(float[] box, int at) {
        for (int k = 0; k < 3; k++) {
            box[at + k] = Float.POSITIVE_INFINITY;
            box[at + k + 3] = Float.NEGATIVE_INFINITY;
        }
    }

    private static void grow(float[] box, int at, float[] by, int byAt) {
        for (int k = 0; k < 3; k++) {
            box[at + k] = Math.min(box[at + k], by[byAt + k]);
            box[at + k + 3] = Math.max(box[at + k + 3], by[byAt + k + 3]);
        }
    }
}
