// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

/**
 * Restitution at the time of impact. A substep ends when two bodies with a restitution collide; the time follows from
 * their free fall. The manifold with the largest approach speed rebounds first by Newton's law of restitution, until
 * none approaches. Impacts so propagate through a row of balls (sequential impacts: Mirtich, "Impulse-based dynamic
 * simulation of rigid body systems", 1996). Simulation thread.
 */
final class Impacts {
    /** Approach speed below which a contact does not bounce, m/s, so that resting bodies do not jitter. */
    private static final double MIN_BOUNCE = 0.3;
    /** Gap at which surfaces touch, metres. */
    private static final double TOUCH = 1.1 * ContactRows.LINEAR_SLOP;
    /** Largest number of shortened substeps in a step. */
    private static final int MAX_CUTS = 12;
    /** Shortest length of a substep, as a share of its full length. */
    private static final double MIN_SHARE = 1e-3;
    /** Passes over the points of a face, whose speeds depend on each other. */
    private static final int PASSES = 12;
    /** Largest number of impacts per manifold at one moment. */
    private static final int MAX_IMPACTS = 8;

    private final double[] speeds = new double[Manifold.MAX_POINTS];
    private final double[] impacts = new double[Manifold.MAX_POINTS];
    private int cuts;

    /** Begins a step. */
    void begin() {
        cuts = 0;
    }

    /**
     * Rebounds contacts that collide now and finds the time of the next impact.
     * @param seconds longest length of the substep
     * @return length of the substep, seconds
     */
    double next(ContactRows rows, double seconds, double gravity) {
        if (!rows.hasBouncing()) {
            return seconds;
        }
        for (int slot = 0; slot < rows.size(); slot++) {
            rows.clearRestitution(slot);
        }
        boolean mayCut = cuts < MAX_CUTS;
        rebound(rows, mayCut ? 0 : seconds);
        double taken = mayCut ? untilNext(rows, seconds, gravity) : seconds;
        if (taken < seconds) {
            cuts++;
        }
        return taken;
    }

    private void rebound(ContactRows rows, double ahead) {
        int left = MAX_IMPACTS * rows.size();
        while (left-- > 0) {
            int hardest = -1;
            double most = MIN_BOUNCE;
            for (int slot = 0; slot < rows.size(); slot++) {
                if (rows.restitution(slot) > 0) {
                    double speed = approach(rows, slot, ahead);
                    if (speed > most) {
                        most = speed;
                        hardest = slot;
                    }
                }
            }
            if (hardest < 0) {
                return;
            }
            impact(rows, hardest, ahead);
        }
    }

    /** Returns the largest approach speed of a manifold's points that touch, or will within a time, m/s. */
    private static double approach(ContactRows rows, int slot, double ahead) {
        double most = 0;
        for (int i = 0; i < rows.points(slot); i++) {
            double speed = -rows.parting(slot, i);
            if (speed > most && rows.gap(slot, i) <= TOUCH + speed * ahead) {
                most = speed;
            }
        }
        return most;
    }

    private void impact(ContactRows rows, int slot, double ahead) {
        for (int i = 0; i < rows.points(slot); i++) {
            double parting = rows.parting(slot, i);
            boolean intersects = rows.gap(slot, i) <= TOUCH - Math.min(0, parting) * ahead && parting < 0;
            speeds[i] = intersects ? -rows.restitution(slot) * parting : Double.NEGATIVE_INFINITY;
            impacts[i] = 0;
        }
        for (int pass = 0; pass < PASSES; pass++) {
            for (int i = 0; i < rows.points(slot); i++) {
                if (speeds[i] >= 0) {
                    impacts[i] = rows.rebound(slot, i, impacts[i], speeds[i]);
                }
            }
        }
        for (int i = 0; i < rows.points(slot); i++) {
            rows.endImpact(slot, i, impacts[i]);
        }
    }

    /** Returns the time until the next impact, seconds. */
    private static double untilNext(ContactRows rows, double seconds, double gravity) {
        double least = seconds;
        for (int slot = 0; slot < rows.size(); slot++) {
            if (rows.restitution(slot) == 0) {
                continue;
            }
            double pull = rows.falling(slot, gravity);
            for (int i = 0; i < rows.points(slot); i++) {
                double parting = rows.parting(slot, i);
                double gap = rows.gap(slot, i);
                if (gap > TOUCH && parting + pull * seconds < -MIN_BOUNCE) {
                    rows.await(slot, i);
                    least = Math.min(least, until(gap - ContactRows.LINEAR_SLOP, parting, pull));
                }
            }
        }
        return Math.max(least, MIN_SHARE * seconds);
    }

    /** Returns the time until a gap closes at a speed and an acceleration, seconds. */
    private static double until(double gap, double speed, double acceleration) {
        double root = speed * speed - 2 * acceleration * gap;
        if (root < 0) {
            return Double.POSITIVE_INFINITY;
        }
        // the smaller positive root of gap + speed t + acceleration t^2 / 2
        double time = 2 * gap / (-speed + Math.sqrt(root));
        return time > 0 ? time : Double.POSITIVE_INFINITY;
    }
}
