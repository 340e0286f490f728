// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import org.SEAR.raycast.tree.Bvh;

/**
 * Stack of boxes that a fan has still to visit: nodes of hierarchies or blocks of a height field. Each box has the
 * range of rays that may hit it, a subset of its parent's range. One thread.
 */
final class CutStack {
    /**
     * Distance from a box, metres, below which the fan's origin counts as close. Far above the touching distance of
     * triangles.
     */
    private static final double CLOSE = 1e-3;
    /** A box that extends sideways by more than this multiple of its distance counts as around the origin. */
    private static final double BROAD = 4;
    /** Exceeds the depth of any hierarchy and four blocks per level of a height field. */
    private static final int DEPTH = 128;

    /** Range of rays that may hit the last popped box. */
    int first;
    int last;
    /**
     * True if the last popped box lies around the origin or the ends of the fan, so that the range says little.
     * Otherwise the range spans less than half a turn.
     */
    boolean around;

    private final DepthBuffer depth;
    private final PlaneCut cut;
    private final long[] boxes = new long[DEPTH];
    private final double[] lefts = new double[DEPTH];
    private final double[] aheads = new double[DEPTH];
    private final double[] wides = new double[DEPTH];
    private final double[] nears = new double[DEPTH];
    private final int[] firsts = new int[DEPTH];
    private final int[] lasts = new int[DEPTH];
    private int size;

    CutStack(DepthBuffer depth, PlaneCut cut) {
        this.depth = depth;
        this.cut = cut;
    }

    void start() {
        size = 0;
        first = 0;
        last = depth.beams.count - 1;
    }

    /** Pushes a child of the last popped box, with the rectangle that the cut computed last. */
    void push(long box) {
        put(size++, box);
    }

    private void put(int at, long box) {
        boxes[at] = box;
        lefts[at] = cut.left;
        aheads[at] = cut.ahead;
        wides[at] = cut.wide;
        nears[at] = cut.nearest;
        firsts[at] = first;
        lasts[at] = last;
    }

    /** Pushes the root of a hierarchy if the plane intersects it. */
    void pushRoot(Bvh tree) {
        if (tree.size() > 0 && cut.intersects(tree.data, 0)) {
            push(0);
        }
    }

    /** Pushes the children of a node that the plane intersects, the nearer one on top. */
    void pushChildren(Bvh tree, int node) {
        int child = tree.link(node);
        boolean both = cut.intersects(tree.data, child * Bvh.STRIDE);
        double distance = cut.distance;
        if (both) {
            push(child);
        }
        if (cut.intersects(tree.data, (child + 1) * Bvh.STRIDE)) {
            if (both && cut.distance > distance) {
                pushBelow(child + 1);
            } else {
                push(child + 1);
            }
        }
    }

    private void pushBelow(long box) {
        int top = size - 1;
        boxes[size] = boxes[top];
        lefts[size] = lefts[top];
        aheads[size] = aheads[top];
        wides[size] = wides[top];
        nears[size] = nears[top];
        firsts[size] = first;
        lasts[size++] = last;
        put(top, box);
    }

    /** Pops the next box that some ray can still hit; returns -1 if none is left. */
    long pop() {
        while (size > 0) {
            size--;
            if (see(lefts[size], aheads[size], wides[size], nears[size])) {
                return boxes[size];
            }
        }
        return -1;
    }

    /** Finds the range of rays that may hit the top box. Returns false if there is none. */
    private boolean see(double left, double ahead, double wide, double nearest) {
        first = firsts[size];
        last = lasts[size];
        around = !(nearest >= CLOSE && wide <= BROAD * nearest);
        if (around) {
            return true;
        }
        double enough = (1 + 1e-12) / nearest;
        if (!narrow(nearest * left, nearest * ahead, wide * left, wide * ahead, enough)) {
            return false;
        }
        while (first <= last && depth.inverse[first] > enough) {
            first++;
        }
        return first <= last;
    }

    /** Excludes rays that pass beside the box. Returns false if no ray is left. */
    private boolean narrow(double left, double ahead, double toSideLeft, double toSideAhead, double enough) {
        FanDirections beams = depth.beams;
        double from = beams.angle(left - toSideAhead, ahead + toSideLeft);
        double to = beams.angle(left + toSideAhead, ahead - toSideLeft);
        if (FanDirections.inOneGo(from, to)) {
            first = Math.max(first, beams.from(from));
            last = Math.min(last, beams.to(to));
            return first <= last;
        }
        if (from > to && beams.from(from) >= beams.count) {
            last = Math.min(last, beams.to(to));
            return first <= last;
        }
        around = true;
        return depth.open(beams.from(from), beams.count - 1, enough) || depth.open(0, beams.to(to), enough);
    }
}
