// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.Arrays;
import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.PrincipalAxes;
import org.SEAR.physics.joint.JointedBody;

/**
 * State of a rigid body in double precision: contacts and wheels change it, substeps integrate it. Its frame has the
 * origin in the centre of mass and the axes of the body's own frame. Simulation thread.
 */
public final class SolverBody extends JointedBody {
    /** Cosine above which normals count as equal. */
    private static final double SAME = 0.9999;
    /** Speeds up to which a body may be moved out of a deep penetration, m/s and rad/s. */
    private static final double MAX_OUT = 0.5;
    private static final double MAX_OUT_TURNING = 3;
    /** Substeps for which a body counts as deep after its last deep contact. */
    private static final int DEEP_FOR = 40;

    /** Displacement since the step began, world frame: metres along and radians about x, y and z. */
    final double[] moved = new double[6];
    /** Whether a contact or a wheel acts on it in this substep; otherwise it falls on a parabola. */
    boolean pressed;
    private final double[] before = new double[6];
    private final double[] from = new double[3];
    private double nx;
    private double ny;
    private double nz;
    private boolean oneNormal;
    private boolean jointed;
    /** Remaining substeps for which it counts as deep. */
    private int deep;
    private final AngularState spin = new AngularState();
    /** Acceleration by external forces in this step, m/s^2. */
    private final double[] pull = new double[3];
    private double seconds;
    private double fallen;
    private long moves;

    /**
     * Sets mass and inertia. Before {@link #put}.
     * @param mass kg, 0 = it never moves
     * @param inertia principal moments and axes in the body's frame
     */
    void setMass(double mass, PrincipalAxes inertia) {
        inverseMass = mass > 0 ? 1 / mass : 0;
        spin.setInertia(inertia);
        refresh();
    }

    /** Teleports the body, at rest. */
    void put(double x, double y, double z, Pose turned) {
        place.x = x;
        place.y = y;
        place.z = z;
        spin.set(turned.qx, turned.qy, turned.qz, turned.qw);
        halt();
        begin();
        end();
        refresh();
    }

    /** Sets all velocities to zero. */
    void halt() {
        for (int i = 0; i < v.length; i++) {
            v[i] = 0;
        }
    }

    /** Adds a force for the next step, N, world frame. */
    void pull(double x, double y, double z) {
        pull[0] += x * inverseMass;
        pull[1] += y * inverseMass;
        pull[2] += z * inverseMass;
    }

    /** Ends a step and clears its forces. */
    void end() {
        pull[0] = 0;
        pull[1] = 0;
        pull[2] = 0;
    }

    /** Begins a step. */
    void begin() {
        for (int i = 0; i < moved.length; i++) {
            moved[i] = 0;
        }
    }

    /** Begins a substep: applies gravity and external forces. */
    void fall(double newSeconds, double gravity) {
        seconds = newSeconds;
        pressed = false;
        oneNormal = false;
        deep = Math.max(0, deep - 1);
        System.arraycopy(v, 0, before, 0, before.length);
        from[0] = place.x;
        from[1] = place.y;
        from[2] = place.z;
        for (int axis = 0; axis < 3; axis++) {
            v[axis] += pull[axis] * seconds;
        }
        fallen = gravity * seconds;
        v[1] -= fallen;
    }

    /**
     * Applies half of the gyroscopic change before the constraints; the other half follows afterwards, so that
     * constraints hold throughout. With joints both follow: their impulses act on the angular momentum at the start of
     * the substep.
     */
    void gyrate() {
        if (!jointed) {
            spin.gyrate(v, seconds / 2);
        }
    }

    /** Sets whether it has a joint. */
    void setJointed(boolean on) {
        jointed = on;
    }

    /** Notes a contact impulse along a normal, in either sense. */
    void press(double x, double y, double z) {
        oneNormal = !pressed || oneNormal && Math.abs(x * nx + y * ny + z * nz) > SAME;
        pressed = true;
        nx = x;
        ny = y;
        nz = z;
    }

    @Override
    public void hold() {
        pressed = true;
        oneNormal = false;
    }

    /** Marks a deep penetration. */
    void setDeep() {
        deep = DEEP_FOR;
    }

    /** Whether it penetrates another body deeply, or did a few substeps ago. */
    boolean isDeep() {
        return deep > 0;
    }

    /** Limits the speed gained while a deep penetration is resolved. */
    void slow() {
        if (deep > 0) {
            limit(0, MAX_OUT);
            limit(3, MAX_OUT_TURNING);
        }
    }

    private void limit(int from, double most) {
        double falls = before[from + 1] - (from == 0 ? fallen : 0);
        double was = Math.sqrt(before[from] * before[from] + falls * falls + before[from + 2] * before[from + 2]);
        double is = Math.sqrt(v[from] * v[from] + v[from + 1] * v[from + 1] + v[from + 2] * v[from + 2]);
        double scale = Math.max(was, most) / is;
        for (int i = from; i < from + 3 && scale < 1; i++) {
            v[i] *= scale;
        }
    }

    /**
     * Trapezoidal position update along one contact plane: the tangential velocity changed evenly during the substep.
     */
    void even() {
        if (!oneNormal) {
            return;
        }
        double x = v[0] - before[0];
        double y = v[1] - before[1];
        double z = v[2] - before[2];
        double along = x * nx + y * ny + z * nz;
        shift(-seconds / 2 * (x - along * nx), -seconds / 2 * (y - along * ny), -seconds / 2 * (z - along * nz));
    }

    private void shift(double x, double y, double z) {
        place.x += x;
        place.y += y;
        place.z += z;
        moved[0] += x;
        moved[1] += y;
        moved[2] += z;
        moves++;
    }

    /** Ends the substep: integrates the pose. */
    void advance(double gravity) {
        double late = pressed ? 0 : seconds * seconds / 2;
        shift(v[0] * seconds - late * pull[0], v[1] * seconds - late * (pull[1] - gravity),
            v[2] * seconds - late * pull[2]);
        for (int i = 3; i < moved.length; i++) {
            moved[i] += v[i] * seconds;
        }
        if (v[3] != 0 || v[4] != 0 || v[5] != 0) {
            turn();
        }
        refresh();
    }

    @Override
    public void correct() {
        double[] c = correction;
        if (c[0] == 0 && c[1] == 0 && c[2] == 0 && c[3] == 0 && c[4] == 0 && c[5] == 0) {
            return;
        }
        shift(c[0], c[1], c[2]);
        for (int i = 3; i < moved.length; i++) {
            moved[i] += c[i];
        }
        spin.turnHeld(c, 1);
        Arrays.fill(c, 0);
        refresh();
    }

    /** Centre of mass at the start of the substep: {x, y, z}, world frame, metres. */
    double[] getFrom() {
        return from;
    }

    /**
     * Moves the body back to where its path meets an obstacle.
     * @param share of the substep's path that it may travel
     * @param x normal of the obstacle, likewise y and z: the velocity along it becomes zero
     */
    void stopAt(double share, double x, double y, double z) {
        double back = 1 - share;
        oneNormal = false;
        shift(-back * (place.x - from[0]), -back * (place.y - from[1]), -back * (place.z - from[2]));
        double along = v[0] * x + v[1] * y + v[2] * z;
        v[0] -= along * x;
        v[1] -= along * y;
        v[2] -= along * z;
    }

    /** Displaces the body along a direction, metres, and removes its velocity against that direction. */
    void lift(double x, double y, double z, double metres) {
        shift(metres * x, metres * y, metres * z);
        oneNormal = false;
        double against = Math.min(0, v[0] * x + v[1] * y + v[2] * z);
        v[0] -= against * x;
        v[1] -= against * y;
        v[2] -= against * z;
    }

    private void turn() {
        if (pressed) {
            if (jointed) {
                spin.gyrate(v, seconds / 2);
            }
            spin.turnHeld(v, seconds);
            spin.gyrate(v, seconds / 2);
        } else {
            System.arraycopy(before, 3, v, 3, 3);
            spin.turn(v, seconds);
        }
    }

    private void refresh() {
        moves++;
        spin.matrix(place);
        Placement axes = spin.principal(place);
        double x = spin.inverseX();
        double y = spin.inverseY();
        double z = spin.inverseZ();
        i00 = axes.m00 * axes.m00 * x + axes.m01 * axes.m01 * y + axes.m02 * axes.m02 * z;
        i01 = axes.m00 * axes.m10 * x + axes.m01 * axes.m11 * y + axes.m02 * axes.m12 * z;
        i02 = axes.m00 * axes.m20 * x + axes.m01 * axes.m21 * y + axes.m02 * axes.m22 * z;
        i11 = axes.m10 * axes.m10 * x + axes.m11 * axes.m11 * y + axes.m12 * axes.m12 * z;
        i12 = axes.m10 * axes.m20 * x + axes.m11 * axes.m21 * y + axes.m12 * axes.m22 * z;
        i22 = axes.m20 * axes.m20 * x + axes.m21 * axes.m21 * y + axes.m22 * axes.m22 * z;
    }

    /** Counter that changes with every movement. */
    long getMoves() {
        return moves;
    }

    /**
     * Computes the lever arm from the centre of mass to a point.
     * @param x of the point, world frame, metres, likewise y and z
     * @param ahead time by which the point rotates on with the body, seconds
     * @param into takes {x, y, z}, metres
     */
    void arm(double x, double y, double z, double ahead, double[] into) {
        double rx = x - place.x;
        double ry = y - place.y;
        double rz = z - place.z;
        into[0] = rx + ahead * (v[4] * rz - v[5] * ry);
        into[1] = ry + ahead * (v[5] * rx - v[3] * rz);
        into[2] = rz + ahead * (v[3] * ry - v[4] * rx);
    }

    /** Returns the magnitude of the angular velocity, rad/s. */
    double turning() {
        return Math.sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5]);
    }

    AngularState spin() {
        return spin;
    }

    /** Length of the present substep, seconds. */
    public double seconds() {
        return seconds;
    }

    /**
     * Returns the displacement of a point of it along a direction since the step began, metres.
     * @param nx unit direction, world frame, likewise ny and nz
     * @param x of the point when the step began, world frame, metres, likewise y and z
     */
    public double travel(double nx, double ny, double nz, double x, double y, double z) {
        double rx = x - (place.x - moved[0]);
        double ry = y - (place.y - moved[1]);
        double rz = z - (place.z - moved[2]);
        return nx * moved[0] + ny * moved[1] + nz * moved[2] + (ry * nz - rz * ny) * moved[3]
            + (rz * nx - rx * nz) * moved[4]
            + (rx * ny - ry * nx) * moved[5];
    }

    /**
     * Applies an angular impulse.
     * @param tx angular impulse, N m s, world frame, likewise ty and tz
     */
    public void twist(double tx, double ty, double tz) {
        v[3] += i00 * tx + i01 * ty + i02 * tz;
        v[4] += i01 * tx + i11 * ty + i12 * tz;
        v[5] += i02 * tx + i12 * ty + i22 * tz;
    }
}
