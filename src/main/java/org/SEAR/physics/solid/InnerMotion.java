package org.SEAR.physics.solid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;

/**
 * How solids move in their body in a step, as servos turn them: contacts see the speed of their surface, and hinges yield to contacts.
 * They are put where they go when the step has ended. Simulation thread.
 */
public final class InnerMotion {
    private static final int NUMBERS = 12;

    private final List<Solid> solids;
    private final Pose[] places;
    private final double[] centre;
    /** Where those that move go; null of all others. */
    private final Pose[] next;
    /** The speed of a point of each as a linear function of where it is in the body's frame: three rows of four numbers, 1/s and m/s. */
    private final double[][] speeds;
    private final Hinge[] hinges;
    private final List<Hinge> all = new ArrayList<>();
    private final double[] own = new double[3];
    private boolean any;
    private double fastest;
    private Runnable yielding = () -> { };

    /**
     * @param places of the solids now, in the body's frame
     * @param centre of the body's mass, likewise
     */
    public InnerMotion(List<Solid> solids, Pose[] places, double... centre) {
        this.solids = solids;
        this.places = places;
        this.centre = centre;
        next = new Pose[places.length];
        speeds = new double[places.length][];
        hinges = new Hinge[places.length];
    }

    /** @param reported is told at the end of a step in which a hinge did not get as far as planned, and says by {@link #move} where solids went */
    public void onYield(Runnable reported) {
        yielding = reported;
    }

    /**
     * A solid goes to another place in this step.
     *
     * @param hinge which yields to what it meets; null if it does not
     */
    public void move(int solid, Pose to, Hinge hinge) {
        Pose from = places[solid];
        next[solid] = to;
        hinges[solid] = hinge;
        if (hinge != null && !all.contains(hinge)) {
            all.add(hinge);
        }
        any = true;
        double cosine = Math.abs(from.qx * to.qx + from.qy * to.qy + from.qz * to.qz + from.qw * to.qw);
        double way = Math.sqrt((to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y) + (to.z - from.z) * (to.z - from.z))
            + 2 * Math.acos(Math.min(1, cosine)) * solids.get(solid).convex().radius();
        fastest = Math.max(fastest, way / TimeStep.SECONDS);
        speeds[solid] = speeds[solid] == null ? new double[NUMBERS] : speeds[solid];
        double[] back = from.rotateBack(-from.x, -from.y, -from.z);
        setSpeeds(speeds[solid], to.times(new Pose(back[0], back[1], back[2], -from.qx, -from.qy, -from.qz, from.qw)));
    }

    private static void setSpeeds(double[] into, Pose change) {
        double[] x = change.rotate(1, 0, 0);
        double[] y = change.rotate(0, 1, 0);
        double[] z = change.rotate(0, 0, 1);
        double[] offset = {change.x, change.y, change.z};
        for (int row = 0; row < 3; row++) {
            into[4 * row] = (x[row] - (row == 0 ? 1 : 0)) / TimeStep.SECONDS;
            into[4 * row + 1] = (y[row] - (row == 1 ? 1 : 0)) / TimeStep.SECONDS;
            into[4 * row + 2] = (z[row] - (row == 2 ? 1 : 0)) / TimeStep.SECONDS;
            into[4 * row + 3] = offset[row] / TimeStep.SECONDS;
        }
    }

    /**
     * The step has ended.
     *
     * @return whether a solid has moved
     */
    public boolean end() {
        boolean moved = any;
        for (int i = 0; i < all.size(); i++) {
            if (all.get(i).ahead() != 0) {
                yielding.run();
                break;
            }
        }
        for (int i = 0; any && i < next.length; i++) {
            places[i] = next[i] == null ? places[i] : next[i];
        }
        forget();
        return moved;
    }

    /** Nothing moves in this step after all. */
    public void forget() {
        if (any) {
            Arrays.fill(next, null);
            Arrays.fill(hinges, null);
            all.clear();
            any = false;
            fastest = 0;
        }
    }

    /** The hinges that turn in this step, a view. */
    public List<Hinge> hinges() {
        return all;
    }

    /** The hinge of a solid that yields to what it meets in this step; null if there is none. */
    public Hinge hinge(int solid) {
        return hinges[solid];
    }

    /** How fast a point of them moves at most, m/s. */
    public double fastest() {
        return fastest;
    }

    /** Whether a solid moves in this step. */
    public boolean moves(int solid) {
        return any && next[solid] != null;
    }

    /**
     * The velocity of a point of a solid, as its body sees it, along a direction.
     *
     * @param at where the body's centre of mass is and how it is turned
     * @param d has a unit direction, world frame, three numbers from {@code i} on
     * @param x of the point, world frame, metres, likewise y and z
     * @param gone how much of the step is over, seconds: each point of the solid goes straight on through the step
     * @return m/s
     */
    public double speed(int solid, Placement at, double[] d, int i, double x, double y, double z, double gone) {
        toStart(solid, at, x, y, z, gone);
        return along(at, d, i, row(solid, 0), row(solid, 4), row(solid, 8));
    }

    private double row(int solid, int first) {
        double[] s = speeds[solid];
        return s[first] * own[0] + s[first + 1] * own[1] + s[first + 2] * own[2] + s[first + 3];
    }

    /** How far a point of a solid goes along a direction when its hinge turns by 1 rad, metres; 0 if it has none. As {@link #speed}. */
    public double lever(int solid, Placement at, double[] d, int i, double x, double y, double z, double gone) {
        if (hinges[solid] == null) {
            return 0;
        }
        toStart(solid, at, x, y, z, gone);
        return hinges[solid].lever(at, d, i, own[0], own[1], own[2]);
    }

    /** Where the point of a solid that is somewhere now was when the step began, in the body's frame. */
    private void toStart(int solid, Placement at, double x, double y, double z, double gone) {
        at.toFrame(x, y, z, own, 0);
        for (int i = 0; i < own.length; i++) {
            own[i] += centre[i];
        }
        double vx = row(solid, 0);
        double vy = row(solid, 4);
        double vz = row(solid, 8);
        own[0] -= gone * vx;
        own[1] -= gone * vy;
        own[2] -= gone * vz;
    }

    /** The share along a direction of the world of a vector {x, y, z} of the body's frame. */
    static double along(Placement at, double[] d, int i, double x, double y, double z) {
        return d[i] * (at.m00 * x + at.m01 * y + at.m02 * z) + d[i + 1] * (at.m10 * x + at.m11 * y + at.m12 * z)
            + d[i + 2] * (at.m20 * x + at.m21 * y + at.m22 * z);
    }
}
