package org.SEAR.physics;

import java.util.List;

/**
 * What bounces: a substep ends at the moment at which two bodies with a restitution meet, and there they are thrown apart, manifold after manifold,
 * each with the speed at which its points come together then, until none comes any more: so a blow goes through a row of balls. Simulation thread.
 */
final class Impacts {
    /** What comes slower than this does not bounce, m/s: else what rests would tremble. */
    private static final double LEAST_BOUNCE = 0.3;
    /** Surfaces this close touch, metres. */
    private static final double TOUCH = 1.1 * Manifold.CLOSE;
    /** A substep is cut short no more often than this in a step. */
    private static final int MOST_CUTS = 12;
    /** A substep is no shorter than this share of what it could be. */
    private static final double LEAST_SHARE = 1e-3;
    /** Passes over the points of a face, which all have to agree how fast it goes. */
    private static final int PASSES = 12;
    /** Blows for each manifold in one moment. */
    private static final int MOST_BLOWS = 8;

    private final double[] speeds = new double[Manifold.MOST_POINTS];
    private int cuts;

    /** A step begins. */
    void begin() {
        cuts = 0;
    }

    /**
     * Throws apart what meets now, and looks when something meets next.
     *
     * @param seconds that the substep may take
     * @return how many it takes
     */
    double next(List<Manifold> manifolds, double seconds, double gravity) {
        boolean bounces = false;
        for (int i = 0; i < manifolds.size(); i++) {
            manifolds.get(i).clearThrown();
            bounces |= manifolds.get(i).restitution > 0;
        }
        if (!bounces) {
            return seconds;
        }
        boolean mayCut = cuts < MOST_CUTS;
        rebound(manifolds, mayCut ? 0 : seconds);
        double taken = mayCut ? untilNext(manifolds, seconds, gravity) : seconds;
        if (taken < seconds) {
            cuts++;
        }
        return taken;
    }

    private void rebound(List<Manifold> manifolds, double ahead) {
        int left = MOST_BLOWS * manifolds.size();
        while (left-- > 0) {
            Manifold hardest = null;
            double most = LEAST_BOUNCE;
            for (int i = 0; i < manifolds.size(); i++) {
                Manifold manifold = manifolds.get(i);
                if (manifold.restitution > 0) {
                    double speed = manifold.approach(TOUCH, ahead);
                    if (speed > most) {
                        most = speed;
                        hardest = manifold;
                    }
                }
            }
            if (hardest == null) {
                return;
            }
            blow(hardest, ahead);
        }
    }

    private void blow(Manifold manifold, double ahead) {
        for (int i = 0; i < manifold.count; i++) {
            ContactPoint point = manifold.points[i];
            double parting = point.parting(manifold);
            boolean meets = point.gap <= TOUCH - Math.min(0, parting) * ahead && parting < 0;
            speeds[i] = meets ? -manifold.restitution * parting : Double.NEGATIVE_INFINITY;
            point.startBlow();
        }
        for (int pass = 0; pass < PASSES; pass++) {
            for (int i = 0; i < manifold.count; i++) {
                if (speeds[i] >= 0) {
                    manifold.points[i].rebound(manifold, speeds[i]);
                }
            }
        }
        for (int i = 0; i < manifold.count; i++) {
            manifold.points[i].endBlow();
        }
    }

    /** When the next that bounces meets, seconds from now. */
    private static double untilNext(List<Manifold> manifolds, double seconds, double gravity) {
        double least = seconds;
        for (int i = 0; i < manifolds.size(); i++) {
            Manifold manifold = manifolds.get(i);
            if (manifold.restitution == 0) {
                continue;
            }
            double pull = manifold.ny * ((manifold.massB > 0 ? gravity : 0) - (manifold.massA > 0 ? gravity : 0));
            for (int k = 0; k < manifold.count; k++) {
                ContactPoint point = manifold.points[k];
                double parting = point.parting(manifold);
                if (point.gap > TOUCH && parting + pull * seconds < -LEAST_BOUNCE) {
                    point.awaited = true;
                    least = Math.min(least, until(point.gap - Manifold.CLOSE, parting, pull));
                }
            }
        }
        return Math.max(least, LEAST_SHARE * seconds);
    }

    /** When a gap closes that changes at a speed, with an acceleration, seconds. */
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
