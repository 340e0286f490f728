// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;

/**
 * Motion of solids in their body during a step, as by servos. Contacts use the velocity of their surface, and hinges
 * yield to contacts. The solids take their new poses at the end of the step. Simulation thread.
 */
public final class InnerMotion {
    private static final int NUMBERS = 12;

    private final List<Solid> solids;
    private final Pose[] places;
    private final double[] centre;
    /** Target pose of each moving solid; null for the others. */
    private final Pose[] next;
    /**
     * Velocity of each solid's points as a linear function of position in the body's frame: three rows of four numbers,
     * 1/s and m/s.
     */
    private final double[][] speeds;
    private final Hinge[] hinges;
    private final List<Hinge> all = new ArrayList<>();
    private final double[] own = new double[3];
    private boolean any;
    private double fastest;
    private Runnable yielding = () -> { };

    /**
     * @param places of the solids now, in the body's frame
     * @param centre of mass, in the body's frame
     */
    public InnerMotion(List<Solid> solids, Pose[] places, double... centre) {
        this.solids = solids;
        this.places = places;
        this.centre = centre;
        next = new Pose[places.length];
        speeds = new double[places.length][];
        hinges = new Hinge[places.length];
    }

    /**
     * @param reported runs at the end of a step in which a hinge deviated from its plan; it calls {@link #move} with
     *     the actual poses
     */
    public void onYield(Runnable reported) {
        yielding = reported;
    }

    /**
     * Moves a solid to another pose in this step.
     * @param hinge yields under load; null if the motion is rigid
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
        double way = Math.sqrt((to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y)
            + (to.z - from.z) * (to.z - from.z))
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
     * Ends the step.
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

    /** Cancels the motion of this step. */
    public void forget() {
        if (any) {
            Arrays.fill(next, null);
            Arrays.fill(hinges, null);
            all.clear();
            any = false;
            fastest = 0;
        }
    }

    /** Hinges that turn in this step, a view. */
    public List<Hinge> hinges() {
        return all;
    }

    /** Hinge of a solid that yields in this step; null if there is none. */
    public Hinge hinge(int solid) {
        return hinges[solid];
    }

    /** Upper bound of the speed of a point, m/s. */
    public double fastest() {
        return fastest;
    }

    /** Whether a solid moves in this step. */
    public boolean moves(int solid) {
        return any && next[solid] != null;
    }

    /**
     * Returns the velocity of a solid's point relative to its body along a direction, m/s.
     * @param at pose of the body's centre of mass
     * @param d holds a unit direction, world frame, three numbers from {@code i} on
     * @param x of the point, world frame, metres, likewise y and z
     * @param gone elapsed time of the step, seconds: each point of the solid moves on a straight line through the step
     */
    public double speed(int solid, Placement at, double[] d, int i, double x, double y, double z, double gone) {
        toStart(solid, at, x, y, z, gone);
        return along(at, d, i, row(solid, 0), row(solid, 4), row(solid, 8));
    }

    private double row(int solid, int first) {
        double[] s = speeds[solid];
        return s[first] * own[0] + s[first + 1] * own[1] + s[first + 2] * own[2] + s[first + 3];
    }

    /**
     * Returns the displacement of a solid's point along a direction per radian of its hinge, metres; 0 without a hinge.
     * Parameters as in {@link #speed}.
     */
    public double lever(int solid, Placement at, double[] d, int i, double x, double y, double z, double gone) {
        if (hinges[solid] == null) {
            return 0;
        }
        toStart(solid, at, x, y, z, gone);
        return hinges[solid].lever(at, d, i, own[0], own[1], own[2]);
    }

    /** Computes where a solid's point was when the step began, in the body's frame. */
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

    /** Projects a vector {x, y, z} of the body's frame on a world direction. */
    static double along(Placement at, double[] d, int i, double x, double y, double z) {
        return d[i] * (at.m00 * x + at.m01 * y + at.m02 * z) + d[i + 1] * (at.m10 * x + at.m11 * y + at.m12 * z)
            + d[i + 2] * (at.m20 * x + at.m21 * y + at.m22 * z);
    }
}
