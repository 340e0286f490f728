package org.SEAR.physics.start;

import java.util.List;
import java.util.Locale;
import org.SEAR.geometry.Aabb;
import org.SEAR.physics.Body;
import org.SEAR.physics.solid.Solid;

/**
 * Warns of models with hollows that move: their contacts use the convex hull, which fills the hollows. Compares the
 * volume of the hull with that inside the triangles, if these are closed.
 */
public final class HullCheck {
    /** Smallest ratio of the volumes that is reported. */
    private static final double LEAST_RATIO = 1.3;
    /** Largest sum of area vectors of closed triangles, relative to the sum of areas: rounding. */
    private static final double CLOSED = 1e-3;
    /** Largest number of warnings. */
    private static final int MAX_REPORTED = 5;
    private static final Aabb EVERYWHERE = everywhere();

    private HullCheck() {
    }

    private static Aabb everywhere() {
        Aabb all = new Aabb();
        for (int axis = 0; axis < 3; axis++) {
            all.set(axis, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
        }
        return all;
    }

    /** Adds a warning for each movable model with hollows, at most five. */
    public static void report(List<Body> bodies, List<String> warnings) {
        int reported = 0;
        for (Body body : bodies) {
            for (Solid solid : body.isFixed() ? List.<Solid>of() : body.solids) {
                double ratio = solid.isMesh() ? solid.convex().volume() / volume(solid) : 0;
                if (ratio >= LEAST_RATIO && reported++ < MAX_REPORTED) {
                    warnings.add(String.format(Locale.ROOT, "contacts of a model of %s use its convex hull, which has %.1f times"
                        + " the volume inside its triangles: its hollows are filled. Split it into convex models on a robot,"
                        + " or leave out its mass", body.isRobot() ? "robot " + body.name : body.name, ratio));
                }
            }
        }
    }

    /** Returns the volume inside the triangles, m^3; infinite if they are not closed. */
    static double volume(Solid solid) {
        double[] sums = new double[5];
        solid.anyTriangle(EVERYWHERE, t -> {
            double squares = 0;
            for (int axis = 0; axis < 3; axis++) {
                int u = (axis + 1) % 3;
                int w = (axis + 2) % 3;
                double n = (t[3 + u] - t[u]) * (t[6 + w] - t[w]) - (t[3 + w] - t[w]) * (t[6 + u] - t[u]);
                sums[axis] += n;
                sums[3] += t[axis] * n / 6;
                squares += n * n;
            }
            sums[4] += Math.sqrt(squares);
            return false;
        });
        double open = Math.abs(sums[0]) + Math.abs(sums[1]) + Math.abs(sums[2]);
        return open > CLOSED * sums[4] || sums[3] == 0 ? Double.POSITIVE_INFINITY : Math.abs(sums[3]);
    }
}
