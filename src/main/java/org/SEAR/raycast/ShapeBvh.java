// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import java.util.Arrays;
import org.SEAR.raycast.tree.Bvh;
import org.SEAR.raycast.tree.BvhBuilder;

/**
 * Hierarchy over the shapes of a scene. New shapes rebuild it; moved shapes are refitted along their path to the root.
 * Much movement also rebuilds it. Results of rays do not depend on its form.
 */
final class ShapeBvh {
    /** Growth of the inner nodes' total surface area at which the tree is rebuilt. */
    private static final double WORN = 2;

    private final Shapes shapes;
    private Bvh tree = new Bvh(new float[0], new int[0]);
    private int shapeCount;
    private int[] leaf = new int[0];
    private int[] parent = new int[0];
    private double area;
    private double freshArea;

    ShapeBvh(Shapes shapes) {
        this.shapes = shapes;
    }

    Bvh tree() {
        return tree;
    }

    /** Applies the poses of the changed shapes. */
    void update(int[] changes, int changeCount) {
        if (shapeCount != shapes.count) {
            build();
            return;
        }
        for (int i = 0; i < changeCount; i++) {
            int node = leaf[changes[i]];
            shapes.bounds(changes[i], tree.data, node * Bvh.STRIDE);
            boolean grown = true;
            for (node = parent[node]; node >= 0 && grown; node = parent[node]) {
                double before = tree.halfArea(node);
                grown = tree.refit(node);
                area += tree.halfArea(node) - before;
            }
        }
        if (area > WORN * freshArea) {
            build();
        }
    }

    private void build() {
        shapeCount = shapes.count;
        float[] boxes = new float[shapeCount * Bvh.BOUNDS];
        for (int i = 0; i < shapeCount; i++) {
            shapes.bounds(i, boxes, i * Bvh.BOUNDS);
        }
        tree = BvhBuilder.build(boxes, 1);
        leaf = Arrays.copyOf(leaf, shapeCount);
        parent = new int[tree.size()];
        area = 0;
        if (tree.size() > 0) {
            adopt(0, -1);
        }
        freshArea = area;
    }

    private void adopt(int node, int parentOfNode) {
        parent[node] = parentOfNode;
        if (tree.count(node) > 0) {
            leaf[tree.items[tree.link(node)]] = node;
            return;
        }
        area += tree.halfArea(node);
        adopt(tree.link(node), node);
        adopt(tree.link(node) + 1, node);
    }
}
