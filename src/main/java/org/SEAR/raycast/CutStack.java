package org.SEAR.raycast;

import org.SEAR.raycast.tree.Bvh;

/**
 * Boxes that a fan still has to visit, the one that was pushed last on top: nodes of hierarchies or blocks of a height field. Each knows the beams
 * that may see into it, which are among those that may see into what it is a part of. One thread.
 */
final class CutStack {
    /** Metres from a box within which the origin counts as close to it: far more than what counts as touching a triangle. */
    private static final double CLOSE = 1e-3;
    /** A box that reaches farther to its sides than this many times its distance is seen as around the origin. */
    private static final double BROAD = 4;
    /** Deeper than any hierarchy, and four blocks of each level of a height field. */
    private static final int DEPTH = 128;

    /** Of the box that was popped last: the beams that may see into it ... */
    int first;
    int last;
    /** ... and whether it lies around the origin or the ends of the fan, so that they say little. Else they are less than half a turn apart. */
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

    /** Adds a part of the box that was popped last: the one that the cut was asked for last. */
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

    /** Adds the root of a hierarchy, if the plane meets it. */
    void pushRoot(Bvh tree) {
        if (tree.size() > 0 && cut.intersects(tree.data, 0)) {
            push(0);
        }
    }

    /** Adds those children of a node that the plane meets, the nearer one on top. */
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

    /** The next box that some beam can still see into, -1 when there is none. */
    long pop() {
        while (size > 0) {
            size--;
            if (see(lefts[size], aheads[size], wides[size], nears[size])) {
                return boxes[size];
            }
        }
        return -1;
    }

    /** Finds the first and the last beam that see into the box on top. */
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

    /** Leaves out beams that pass beside the box, whose sides are seen as an angle with this tangent. Answers whether any is left. */
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
