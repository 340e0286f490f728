package org.SEAR.physics.solid;

import java.util.Arrays;
import java.util.List;
import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;

/**
 * How solids move in their body in a step, as servos turn them: contacts see the speed of their surface. They are put where they go when the step has
 * ended. Simulation thread.
 */
public final class InnerMotion {
    private final List<Solid> solids;
    private final Pose[] places;
    private final double[] centre;
    /** Where those that move go; null of all others. */
    private final Pose[] next;
    private boolean any;
    private double fastest;

    /**
     * @param places of the solids now, in the body's frame
     * @param centre of the body's mass, likewise
     */
    public InnerMotion(List<Solid> solids, Pose[] places, double... centre) {
        this.solids = solids;
        this.places = places;
        this.centre = centre;
        next = new Pose[places.length];
    }

    /** A solid goes to another place in this step. */
    public void move(int solid, Pose to) {
        Pose from = places[solid];
        next[solid] = to;
        any = true;
        double cosine = Math.abs(from.qx * to.qx + from.qy * to.qy + from.qz * to.qz + from.qw * to.qw);
        double way = Math.sqrt((to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y) + (to.z - from.z) * (to.z - from.z))
            + 2 * Math.acos(Math.min(1, cosine)) * solids.get(solid).convex().radius();
        fastest = Math.max(fastest, way / TimeStep.SECONDS);
    }

    /**
     * The step has ended.
     *
     * @return whether a solid has moved
     */
    public boolean end() {
        boolean moved = any;
        for (int i = 0; any && i < next.length; i++) {
            places[i] = next[i] == null ? places[i] : next[i];
        }
        if (any) {
            Arrays.fill(next, null);
            any = false;
            fastest = 0;
        }
        return moved;
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
     * @param d unit direction, world frame
     * @param x of the point, world frame, metres, likewise y and z
     * @return m/s
     */
    public double speed(int solid, Placement at, double[] d, double x, double y, double z) {
        double[] own = new double[3];
        at.toFrame(x, y, z, own, 0);
        for (int i = 0; i < own.length; i++) {
            own[i] += centre[i];
        }
        Pose now = places[solid];
        double[] point = now.rotateBack(own[0] - now.x, own[1] - now.y, own[2] - now.z);
        double[] to = next[solid].transform(point[0], point[1], point[2]);
        double dx = to[0] - own[0];
        double dy = to[1] - own[1];
        double dz = to[2] - own[2];
        return (d[0] * (at.m00 * dx + at.m01 * dy + at.m02 * dz) + d[1] * (at.m10 * dx + at.m11 * dy + at.m12 * dz)
            + d[2] * (at.m20 * dx + at.m21 * dy + at.m22 * dz)) / TimeStep.SECONDS;
    }
}
