// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.List;

/**
 * Guides balls over shallow edges of meshes. A mesh approximates a smooth surface, on which a ball loses no energy. At
 * a concave edge of two flat triangles it would lose 5/7 of the squared angle by a plastic impact. Instead, the
 * velocities turn by the angle between the triangles, and the impulses of the triangle behind pass to the one ahead.
 * Simulation thread.
 */
final class SmoothEdges {
    /** Cosine of the largest angle of an edge, 8 degrees: 45 or more facets make a circle. */
    private static final double COSINE = 0.9903;
    /** Allowance for rounding in the angle between velocity and triangle, as a factor of its squared sine. */
    private static final double ROUNDING = 1.02;
    /** Largest number of substeps of a step that end at an edge. */
    private static final int MAX_CUTS = 12;
    /** Share of the substep within which a ball has reached a triangle: no shorter substep ends there. */
    private static final double REACHED = 0.05;

    private int cuts;

    /** Begins a step. */
    void begin() {
        cuts = 0;
    }

    /**
     * Turns the velocities of balls that reach a triangle, and finds the time of the next edge.
     * @param ofMeshes contacts with meshes
     * @param seconds longest length of the substep
     * @param exact whether the substep may end at an edge; otherwise the velocities turn before it
     * @return length of the substep, seconds
     */
    double next(List<PairContacts> ofMeshes, ContactRows rows, double seconds, boolean exact) {
        double least = seconds;
        for (int i = 0; i < ofMeshes.size(); i++) {
            least = Math.min(least, ofMeshes.get(i).turnAtEdges(rows, seconds, exact && cuts < MAX_CUTS));
        }
        cuts += least < seconds ? 1 : 0;
        return least;
    }

    /**
     * Turns the velocities of a ball that reaches a triangle.
     * @param slots of its contacts with the mesh, of which the first {@code count} count
     * @param seconds length of the next substep
     * @param exact whether the substep may end at the next triangle; otherwise the velocities turn now
     * @return time until the ball reaches the next triangle, at most {@code seconds}
     */
    static double turn(ContactRows rows, int[] slots, int count, double seconds, boolean exact) {
        double least = seconds;
        for (int i = 0; i < count; i++) {
            int slot = slots[i];
            if (rows.points(slot) != 1) {
                continue;
            }
            double gap = rows.gap(slot) - ContactRows.LINEAR_SLOP;
            double parting = rows.parting(slot, 0);
            double closing = -Math.max(0, gap) / seconds;
            int behind = parting < closing ? supporting(rows, slots, count, slot) : -1;
            if (behind >= 0 && exact && gap > -parting * REACHED * seconds) {
                least = Math.min(least, -gap / parting);
            } else if (behind >= 0 && isAlong(rows.manifold(behind), rows.manifold(slot))) {
                turn(rows.manifold(slot), closing);
                rows.passOn(behind, slot);
            }
        }
        return least;
    }

    /**
     * Turns the velocities of a ball that has rolled over a convex edge, as a pivot about the edge does, if gravity
     * holds the ball there.
     * @param before its manifolds with the mesh, of which the first {@code countBefore} count; {@code now} likewise
     * @param gravity m/s^2
     */
    static void follow(Manifold[] before, int countBefore, Manifold[] now, int count, double gravity) {
        Manifold behind = supporting(before, countBefore);
        Manifold ahead = supporting(now, count);
        double[] v = ahead.a.v;
        double parting = v[0] * ahead.nx + v[1] * ahead.ny + v[2] * ahead.nz;
        double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        if (parting > 0 && behind.points[0].impulse > 0 && square < gravity * ahead.ny * ahead.bodyA.getReach()
                && cosine(behind, ahead) > COSINE && isAlong(behind, ahead)) {
            turn(ahead, 0);
        }
    }

    /** Returns the manifold with the largest impulse. */
    private static Manifold supporting(Manifold[] of, int count) {
        Manifold best = of[0];
        for (int i = 1; i < count; i++) {
            best = of[i].points[0].impulse > best.points[0].impulse ? of[i] : best;
        }
        return best;
    }

    /** Returns the slot with the largest impulse whose triangle meets that of another at a shallow angle, or -1. */
    private static int supporting(ContactRows rows, int[] slots, int count, int ahead) {
        int best = -1;
        double most = 0;
        for (int i = 0; i < count; i++) {
            if (slots[i] != ahead && rows.points(slots[i]) == 1 && rows.impulse(slots[i], 0) > most
                    && cosine(rows.manifold(slots[i]), rows.manifold(ahead)) > COSINE) {
                best = slots[i];
                most = rows.impulse(best, 0);
            }
        }
        return best;
    }

    private static double cosine(Manifold one, Manifold other) {
        return one.nx * other.nx + one.ny * other.ny + one.nz * other.nz;
    }

    /** Whether the ball comes along the triangle behind. */
    private static boolean isAlong(Manifold behind, Manifold ahead) {
        double[] v = ahead.a.v;
        double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        double normal = v[0] * ahead.nx + v[1] * ahead.ny + v[2] * ahead.nz;
        double cosine = cosine(behind, ahead);
        return normal * normal <= ROUNDING * (1 - cosine * cosine) * square;
    }

    /**
     * Rotates the velocities in the plane of the velocity and the normal ahead.
     * @param closing speed along the normal ahead after that, m/s, smaller than the present one
     */
    private static void turn(Manifold ahead, double closing) {
        double[] v = ahead.a.v;
        double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        double normal = v[0] * ahead.nx + v[1] * ahead.ny + v[2] * ahead.nz;
        double along = Math.sqrt(square - normal * normal);
        double tx = (v[0] - normal * ahead.nx) / along;
        double ty = (v[1] - normal * ahead.ny) / along;
        double tz = (v[2] - normal * ahead.nz) / along;
        double after = Math.sqrt(square - closing * closing);
        double c = (along * after + normal * closing) / square;
        double s = (along * closing - normal * after) / square;
        rotate(v, 0, tx, ty, tz, ahead, c, s);
        rotate(v, 3, tx, ty, tz, ahead, c, s);
    }

    private static void rotate(double[] v, int at, double tx, double ty, double tz, Manifold ahead, double c,
            double s) {
        double t = v[at] * tx + v[at + 1] * ty + v[at + 2] * tz;
        double n = v[at] * ahead.nx + v[at + 1] * ahead.ny + v[at + 2] * ahead.nz;
        double dt = c * t - s * n - t;
        double dn = s * t + c * n - n;
        v[at] += dt * tx + dn * ahead.nx;
        v[at + 1] += dt * ty + dn * ahead.ny;
        v[at + 2] += dt * tz + dn * ahead.nz;
    }
}
