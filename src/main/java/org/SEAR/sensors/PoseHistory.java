// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Arrays;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;

/**
 * Poses of a sensor in the latest steps, and those between them: body and mount turn about a fixed axis at constant
 * speed within a step. Allocates nothing after construction. One thread at a time.
 */
final class PoseHistory {
    /** Remembered steps, two seconds. */
    private static final int STEPS = 121;
    /** Largest movement of a sensor at rest: metres, and components of a unit quaternion. */
    private static final double REST = 1e-6;

    private final Pose[] bodies = new Pose[STEPS];
    private final Pose[] mounts = new Pose[STEPS];
    private final Rotation body = new Rotation();
    private final Rotation mount = new Rotation();
    /** First and last remembered step; 0 and -1 without any. */
    private long first;
    private long last = -1;
    /** Step since which the sensor has been at rest, and its pose then. */
    private long restSince = Long.MIN_VALUE;
    private Pose restBody;
    private Pose restMount;
    /** Origin in the world, metres, after {@link #find}. */
    double x;
    double y;
    double z;
    /** Direction in the world, unit vector, after {@link #aim}. */
    double dx;
    double dy;
    double dz;

    /**
     * Forgets all poses.
     *
     * @param atRest whether the sensor was at rest until the next step: at a start, not at a teleport
     */
    void clear(boolean atRest) {
        first = 0;
        last = -1;
        restSince = atRest ? Long.MIN_VALUE : Long.MAX_VALUE;
        restBody = null;
        restMount = null;
        Arrays.fill(bodies, null);
        Arrays.fill(mounts, null);
    }

    /** Remembers the pose after a step: body in the world, mount in the body frame. */
    void add(long step, Pose newBody, Pose newMount) {
        if (last < 0) {
            first = step;
        }
        if (restBody == null || hasMoved(restBody, newBody) || hasMoved(restMount, newMount)) {
            restSince = restBody == null && restSince == Long.MIN_VALUE ? restSince : step;
            restBody = newBody;
            restMount = newMount;
        }
        last = step;
        first = Math.max(first, step - STEPS + 1);
        bodies[(int) (step % STEPS)] = newBody;
        mounts[(int) (step % STEPS)] = newMount;
    }

    private static boolean hasMoved(Pose a, Pose b) {
        return a != b && Math.max(Math.max(Math.max(Math.abs(a.x - b.x), Math.abs(a.y - b.y)), Math.abs(a.z - b.z)),
            Math.max(Math.max(Math.abs(a.qx - b.qx), Math.abs(a.qy - b.qy)),
                Math.max(Math.abs(a.qz - b.qz), Math.abs(a.qw - b.qw)))) > REST;
    }

    private static Pose at(Pose[] ring, long step) {
        return ring[(int) (step % STEPS)];
    }

    /**
     * Returns whether the sensor had the same pose at two times and all steps since.
     *
     * @param time in steps since the start
     * @param step also in the past
     * @param now current step; without its pose, for example after a teleport, the result is true
     */
    boolean isAtRest(double time, long step, long now) {
        return last != now || restSince <= Math.min(step, time);
    }

    /** Returns whether no step is remembered. */
    boolean isEmpty() {
        return last < 0;
    }

    /**
     * Finds the pose at a time. Before the first remembered step it is that of this step; after the last one the
     * movement continues for at most one step.
     *
     * @param time in steps since the start
     */
    void find(double time) {
        long from = Math.max(first, Math.min(last - 1, (long) Math.floor(time)));
        long to = Math.min(last, from + 1);
        double part = Math.max(0, Math.min(2, time - from));
        Pose a = at(bodies, from);
        Pose b = at(bodies, to);
        turn(body, a, b, part);
        Pose c = at(mounts, from);
        Pose d = at(mounts, to);
        turn(mount, c, d, part);
        double mx = c.x + part * (d.x - c.x);
        double my = c.y + part * (d.y - c.y);
        double mz = c.z + part * (d.z - c.z);
        x = a.x + part * (b.x - a.x) + body.outX(mx, my, mz);
        y = a.y + part * (b.y - a.y) + body.outY(mx, my, mz);
        z = a.z + part * (b.z - a.z) + body.outZ(mx, my, mz);
    }

    private static void turn(Rotation out, Pose a, Pose b, double part) {
        out.between(a.qx, a.qy, a.qz, a.qw, b.qx, b.qy, b.qz, b.qw, part);
    }

    /** Computes the direction of a beam in the found pose's x-z plane: sine and cosine of its angle to the left. */
    void aim(double sine, double cosine) {
        double bx = mount.outX(sine, 0, cosine);
        double by = mount.outY(sine, 0, cosine);
        double bz = mount.outZ(sine, 0, cosine);
        dx = body.outX(bx, by, bz);
        dy = body.outY(bx, by, bz);
        dz = body.outZ(bx, by, bz);
    }
}
