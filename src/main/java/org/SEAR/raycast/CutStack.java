package org.SEAR.raycast;

import org.SEAR.raycast.tree.Bvh;

/** Nodes that a fan still has to visit, each with the rectangle of its part of the plane, the nearest on top. */
final class CutStack {
    private static final int STRIDE = 5;
    private final int[] nodes = new int[Bvh.MAX_DEPTH];
    private final double[] parts = new double[Bvh.MAX_DEPTH * STRIDE];
    private int size;

    /** Starts with the root, if the plane meets it. */
    void start(Bvh tree, PlaneCut cut, double reachSquared) {
        size = 0;
        if (tree.size() > 0) {
            push(tree, 0, cut, reachSquared);
        }
    }

    private double push(Bvh tree, int node, PlaneCut cut, double reachSquared) {
        if (!cut.meets(tree.data, node * Bvh.STRIDE)) {
            return -1;
        }
        double distance = cut.distanceSquared();
        if (distance > reachSquared) {
            return -1;
        }
        int at = size * STRIDE;
        parts[at] = cut.minX;
        parts[at + 1] = cut.maxX;
        parts[at + 2] = cut.minZ;
        parts[at + 3] = cut.maxZ;
        parts[at + 4] = distance;
        nodes[size++] = node;
        return cut.centreDistance();
    }

    /** Adds those children of an inner node that the plane meets within reach. */
    void pushChildren(Bvh tree, int node, PlaneCut cut, double reachSquared) {
        int children = tree.link(node);
        double right = push(tree, children + 1, cut, reachSquared);
        double left = push(tree, children, cut, reachSquared);
        if (left > right && right >= 0) {
            swapTop();
        }
    }

    private void swapTop() {
        int top = (size - 1) * STRIDE;
        for (int k = top; k < top + STRIDE; k++) {
            double part = parts[k];
            parts[k] = parts[k - STRIDE];
            parts[k - STRIDE] = part;
        }
        int node = nodes[size - 1];
        nodes[size - 1] = nodes[size - 2];
        nodes[size - 2] = node;
    }

    /** The next node that some beam can still see into, -1 when there is none. */
    int pop(DepthBuffer depth) {
        while (size > 0) {
            size--;
            int at = size * STRIDE;
            if (depth.sees(parts[at], parts[at + 1], parts[at + 2], parts[at + 3], parts[at + 4])) {
                return nodes[size];
            }
        }
        return -1;
    }
}
