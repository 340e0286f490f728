// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.Arrays;
import java.util.List;

/**
 * Resolves penetrations after the bodies of an island have moved. Sequential impulses act on pseudo-velocities, which
 * move the bodies once and are then forgotten (split impulse: Bullet; Erleben 2004). Velocities stay untouched, so a
 * correction adds no kinetic energy, and stacks come to rest. Simulation thread.
 */
final class PositionCorrection {
    /** Penetration that stays, metres: contacts at rest keep touching. */
    private static final double SLOP = 2e-5;
    /** Rate of the correction, 1/s. */
    private static final double RATE = 8;
    /** Largest share of a penetration that one substep corrects. */
    private static final double MAX_SHARE = 0.2;
    /** Largest speed of the correction, m/s. */
    private static final double MAX_SPEED = 1;
    /** Largest penetration into a fixed body, as a share of the body's smallest half extent. */
    private static final double DEEPEST_SHARE = 0.5;

    private double[] impulses = {};

    /**
     * Moves penetrating bodies apart.
     *
     * @param seconds length of the substep
     */
    void run(ContactRows rows, List<Body> bodies, double seconds) {
        boolean penetrates = false;
        for (int slot = 0; slot < rows.size(); slot++) {
            if (rows.points(slot) > 0) {
                rows.measure(slot);
                stayOut(rows, slot);
                penetrates |= rows.gap(slot) < -SLOP;
            }
        }
        if (!penetrates) {
            return;
        }
        int size = rows.size() * Manifold.MAX_POINTS;
        if (impulses.length < size) {
            impulses = new double[2 * size];
        }
        Arrays.fill(impulses, 0, size, 0);
        double share = Math.min(MAX_SHARE, RATE * seconds);
        for (int slot = 0; slot < rows.size(); slot++) {
            for (int i = 0; i < rows.points(slot); i++) {
                double gap = rows.gap(slot, i) + SLOP;
                double distance = gap < 0 ? Math.min(MAX_SPEED * seconds, -gap * share) : -gap;
                int at = slot * Manifold.MAX_POINTS + i;
                impulses[at] = rows.separate(slot, i, distance, impulses[at]);
            }
        }
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getSolver().correct();
        }
    }

    /**
     * Limits the penetration into a fixed body to half of the smallest half extent; beyond its centre the body would
     * come out on the far side.
     */
    private static void stayOut(ContactRows rows, int slot) {
        int out = rows.out(slot);
        if (out == 0) {
            return;
        }
        Manifold of = rows.manifold(slot);
        Body body = out > 0 ? of.bodyA : of.bodyB;
        double deepest = rows.gap(slot) + DEEPEST_SHARE * body.getLeast();
        if (deepest < 0 && body.isSolved()) {
            body.getSolver().lift(out * of.nx, out * of.ny, out * of.nz, -deepest);
            rows.measure(slot);
        }
    }
}
