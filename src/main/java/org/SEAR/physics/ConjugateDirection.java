// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

/**
 * Accelerates passes over contacts: after each pass, impulses go on along a conjugate direction (Silcowitz-Hansen,
 * Niebe, Erleben 2010, "A nonsmooth nonlinear conjugate gradient method for interactive contact force problems"; the
 * factor is that of Fletcher and Reeves). A wall of twenty rows needs some thirty passes instead of several hundred.
 * Simulation thread.
 */
final class ConjugateDirection {
    private double[] change = {};
    private double[] direction = {};
    private double lengthBefore;

    /** Begins the passes of a substep. */
    void begin() {
        lengthBefore = 0;
    }

    /** Stores the impulses before a pass. */
    void store(ContactRows rows) {
        int size = rows.size() * ContactRows.IMPULSES;
        if (change.length < size) {
            change = new double[2 * size];
            direction = new double[2 * size];
        }
        for (int slot = 0; slot < rows.size(); slot++) {
            for (int i = 0; i < ContactRows.IMPULSES; i++) {
                if (isUsed(rows, slot, i)) {
                    change[slot * ContactRows.IMPULSES + i] = rows.impulse(slot, i);
                }
            }
        }
    }

    /** Moves the impulses on after a pass. The next pass brings them back into their limits. */
    void advance(ContactRows rows) {
        double length = 0;
        for (int slot = 0; slot < rows.size(); slot++) {
            for (int i = 0; i < ContactRows.IMPULSES; i++) {
                if (isUsed(rows, slot, i)) {
                    int at = slot * ContactRows.IMPULSES + i;
                    change[at] = rows.impulse(slot, i) - change[at];
                    length += change[at] * change[at];
                }
            }
        }
        boolean first = lengthBefore == 0;
        double factor = first ? 0 : length / lengthBefore;
        lengthBefore = length;
        for (int slot = 0; slot < rows.size(); slot++) {
            for (int i = 0; i < ContactRows.IMPULSES; i++) {
                if (isUsed(rows, slot, i)) {
                    advance(rows, slot, i, factor, first);
                }
            }
        }
    }

    private void advance(ContactRows rows, int slot, int i, double factor, boolean first) {
        int at = slot * ContactRows.IMPULSES + i;
        if (first) {
            direction[at] = change[at];
        } else if (factor > 1) {
            direction[at] = 0;
        } else {
            double more = factor * direction[at];
            direction[at] = more + change[at];
            if (more != 0) {
                rows.addImpulse(slot, i, more);
            }
        }
    }

    private static boolean isUsed(ContactRows rows, int slot, int i) {
        return rows.points(slot) > 0 && (i >= Manifold.MAX_POINTS || i < rows.points(slot));
    }
}
