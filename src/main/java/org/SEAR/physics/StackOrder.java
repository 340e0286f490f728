// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Stack levels of an island's bodies above fixed ones, and the order in which their contacts are solved. The top comes
 * first: in one pass each body feels the weight of all bodies above it, and fixed bodies come last. Stacks then come to
 * rest sooner with fewer passes. Simulation thread.
 */
final class StackOrder {
    /** Level of a body without support: higher than any stack. */
    private static final int FLYING = 1_000_000_000;

    private final List<PairContacts> unsorted = new ArrayList<>();
    /** Number of pairs per level from the highest on, later the start of each level. */
    private int[] begins = {};
    private int highest;

    /** Sets the levels and returns the highest one; bodies without support do not count. */
    int measure(List<Body> bodies, List<PairContacts> pairs) {
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).level = FLYING;
        }
        boolean changed = true;
        while (changed) {
            changed = false;
            for (int i = 0; i < pairs.size(); i++) {
                changed |= lower(pairs.get(i).getA(), pairs.get(i).getB())
                    | lower(pairs.get(i).getB(), pairs.get(i).getA());
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

    /** Sorts the measured pairs: unsupported bodies first, then from top to bottom; the order within a level stays. */
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

    /** Levels from the unsupported bodies down to the upper body of a pair. */
    private int depth(PairContacts pair) {
        int level = Math.max(level(pair.getA()), level(pair.getB()));
        return highest + 1 - Math.min(level, highest + 1);
    }

    private static int level(Body body) {
        return body.isSolved() ? body.level : 0;
    }
}
