// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.TimeStep;

/**
 * Finds pairs of bodies that may touch within a step. Sweep and prune (Baraff, "Dynamic simulation of non-penetrating
 * rigid bodies", 1992): boxes are sorted along the axis of largest variance, and only boxes that overlap along it are
 * compared. Insertion sort is fast because the order hardly changes between steps. A pair keeps its contacts while its
 * boxes overlap. Pairs are in the order in which they began to overlap. Simulation thread.
 */
final class BroadPhase {
    /**
     * Margin around a body and its predicted motion, metres: more than half of the contact margin, because an impact
     * speeds bodies up within the step.
     */
    private static final double MARGIN = 0.01;
    /** The sweep axis changes when the variance of the box centres along another axis exceeds this multiple. */
    private static final double MORE = 2;
    /** Numbers per box. */
    private static final int ENDS = 5;

    private final NarrowPhase finder;
    /** Bodies that can touch an awake one, sorted. */
    private Body[] order = new Body[64];
    private int size;
    private double[] lows = new double[64];
    private double[] ends = new double[64 * ENDS];
    private int axis;
    private final double[] sums = new double[3];
    private final double[] squares = new double[3];
    private final List<PairContacts> pairs = new ArrayList<>();
    private final List<PairContacts> unused = new ArrayList<>();
    private PairContacts[] buckets = new PairContacts[256];
    private int sweeps;

    BroadPhase(NarrowPhase finder) {
        this.finder = finder;
    }

    void add(Body body) {
        if (size == order.length) {
            order = Arrays.copyOf(order, 2 * size);
            lows = new double[2 * size];
            ends = new double[2 * size * ENDS];
        }
        order[size++] = body;
    }

    void remove(Body body) {
        int at = 0;
        while (order[at] != body) {
            at++;
        }
        size--;
        System.arraycopy(order, at + 1, order, at, size - at);
        order[size] = null;
    }

    /** Finds the pairs of this step and the contacts of awake pairs. */
    void find() {
        sweeps++;
        chooseAxis();
        sort();
        sweep();
        forgetParted();
        for (int i = 0; i < pairs.size(); i++) {
            pairs.get(i).find();
        }
    }

    /** Updates the boxes and chooses the axis of largest variance. */
    private void chooseAxis() {
        Arrays.fill(sums, 0);
        Arrays.fill(squares, 0);
        for (int i = 0; i < size; i++) {
            Aabb box = order[i].getNear();
            order[i].bounds(box);
            order[i].widen(box, TimeStep.SECONDS);
            box.grow(MARGIN);
            if (!order[i].isFixed()) {
                for (int k = 0; k < 3; k++) {
                    double middle = box.min(k) + box.max(k);
                    sums[k] += middle;
                    squares[k] += middle * middle;
                }
            }
        }
        int best = axis;
        for (int k = 0; k < 3; k++) {
            best = spread(k) > (best == axis ? MORE : 1) * spread(best) ? k : best;
        }
        axis = best;
    }

    /** Returns the scaled variance of the box centres. */
    private double spread(int along) {
        return squares[along] - sums[along] * sums[along] / Math.max(1, size);
    }

    private void sort() {
        for (int i = 0; i < size; i++) {
            Body body = order[i];
            double low = body.getNear().min(axis);
            int k = i;
            while (k > 0 && (lows[k - 1] > low || lows[k - 1] == low && order[k - 1].number > body.number)) {
                lows[k] = lows[k - 1];
                order[k] = order[k - 1];
                k--;
            }
            lows[k] = low;
            order[k] = body;
        }
    }

    private void sweep() {
        int second = (axis + 1) % 3;
        int third = (axis + 2) % 3;
        for (int i = 0; i < size; i++) {
            Aabb box = order[i].getNear();
            int at = i * ENDS;
            ends[at] = box.max(axis);
            ends[at + 1] = box.min(second);
            ends[at + 2] = box.max(second);
            ends[at + 3] = box.min(third);
            ends[at + 4] = box.max(third);
        }
        for (int i = 0; i < size; i++) {
            int at = i * ENDS;
            for (int k = i + 1; k < size && lows[k] <= ends[at]; k++) {
                int other = k * ENDS;
                if (ends[other + 1] <= ends[at + 2] && ends[at + 1] <= ends[other + 2]
                    && ends[other + 3] <= ends[at + 4]
                    && ends[at + 3] <= ends[other + 4]) {
                    intersect(order[i], order[k]);
                }
            }
        }
    }

    private void intersect(Body one, Body other) {
        if (one.isFixed() && other.isFixed() || one.ignores(other)) {
            return;
        }
        Body first = one.number < other.number ? one : other;
        Body second = first == one ? other : one;
        int bucket = bucket(first, second);
        PairContacts pair = buckets[bucket];
        while (pair != null && !pair.isOf(first, second)) {
            pair = pair.next;
        }
        if (pair == null) {
            pair = unused.isEmpty() ? new PairContacts(finder) : unused.remove(unused.size() - 1);
            pair.begin(first, second);
            pair.next = buckets[bucket];
            buckets[bucket] = pair;
            pairs.add(pair);
            if (pairs.size() > buckets.length) {
                rehash();
            }
        }
        pair.hit = sweeps;
    }

    private int bucket(Body first, Body second) {
        int hash = (first.number * 0x9E3779B1 + second.number) * 0x85EBCA6B;
        return (hash ^ hash >>> 15) & buckets.length - 1;
    }

    private void rehash() {
        buckets = new PairContacts[4 * buckets.length];
        for (int i = 0; i < pairs.size(); i++) {
            PairContacts pair = pairs.get(i);
            int bucket = bucket(pair.first, pair.second);
            pair.next = buckets[bucket];
            buckets[bucket] = pair;
        }
    }

    private void forgetParted() {
        int kept = 0;
        for (int i = 0; i < pairs.size(); i++) {
            PairContacts pair = pairs.get(i);
            if (pair.hit == sweeps) {
                pairs.set(kept++, pair);
            } else {
                unhash(pair);
                unused.add(pair);
            }
        }
        for (int i = pairs.size() - 1; i >= kept; i--) {
            pairs.remove(i);
        }
    }

    private void unhash(PairContacts parted) {
        int bucket = bucket(parted.first, parted.second);
        if (buckets[bucket] == parted) {
            buckets[bucket] = parted.next;
            return;
        }
        PairContacts before = buckets[bucket];
        while (before.next != parted) {
            before = before.next;
        }
        before.next = parted.next;
    }
}
