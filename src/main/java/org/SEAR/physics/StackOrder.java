package org.SEAR.physics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Over how many others each body of an island stands on what is fixed, and the order in which its contacts are solved: those on top first, so that in
 * one pass each body hears what all above it weigh, and what is fixed has the last word. Heaps come to rest sooner so, with fewer passes. Simulation
 * thread.
 */
final class StackOrder {
    /** The level of what stands on nothing: higher than any stack. */
    private static final int FLYING = 1_000_000_000;

    private final List<PairContacts> unsorted = new ArrayList<>();
    /** Pairs of each level, counted from the highest, then where they begin. */
    private int[] begins = {};
    private int highest;

    /** Over how many bodies the one that is farthest from all that is fixed stands on that; what flies stands on nothing. */
    int measure(List<Body> bodies, List<PairContacts> pairs) {
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).level = FLYING;
        }
        boolean changed = true;
        while (changed) {
            changed = false;
            for (int i = 0; i < pairs.size(); i++) {
                changed |= lower(pairs.get(i).getA(), pairs.get(i).getB()) | lower(pairs.get(i).getB(), pairs.get(i).getA());
            }
        }
        highest = 0;
        for (int i = 0; i < bodies.size(); i++) {
            int level = bodies.get(i).level;
            highest = level < FLYING ? Math.max(highest, level) : highest;
        }
        return highest;
    }

    private static boolean lower(Body on, Body under) {
        int level = under.isSolved() ? under.level + 1 : 1;
        if (!on.isSolved() || on.level <= level) {
            return false;
        }
        on.level = level;
        return true;
    }

    /** Puts the pairs that were measured last in order: what flies, then what is on top, then what is below; in one level they keep theirs. */
    void sort(List<PairContacts> pairs) {
        if (highest < 2) {
            return;
        }
        if (begins.length < highest + 2) {
            begins = new int[2 * highest + 2];
        }
        Arrays.fill(begins, 0);
        unsorted.clear();
        for (int i = 0; i < pairs.size(); i++) {
            unsorted.add(pairs.get(i));
            begins[depth(pairs.get(i))]++;
        }
        int sum = 0;
        for (int depth = 0; depth <= highest + 1; depth++) {
            int count = begins[depth];
            begins[depth] = sum;
            sum += count;
        }
        for (int i = 0; i < unsorted.size(); i++) {
            pairs.set(begins[depth(unsorted.get(i))]++, unsorted.get(i));
        }
    }

    /** How far below what flies the upper one of a pair is. */
    private int depth(PairContacts pair) {
        int level = Math.max(level(pair.getA()), level(pair.getB()));
        return highest + 1 - Math.min(level, highest + 1);
    }

    private static int level(Body body) {
        return body.isSolved() ? body.level : 0;
    }
}
