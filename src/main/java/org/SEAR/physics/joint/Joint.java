// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

import java.util.Arrays;
import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;

/**
 * Joint of two bodies, or of a body and the world. Its frame is fixed in each body; both frames coincide at the start.
 * Simulation thread.
 */
public abstract class Joint {
    private static final JointedBody WORLD = new JointedBody.World();

    private final JointedBody a;
    private final JointedBody b;
    private final JointedBody[] ends;
    private final Placement ownA = new Placement();
    private final Placement ownB = new Placement();
    /** Frame of the joint on the first body and on the second, in the world. */
    final Placement onA = new Placement();
    final Placement onB = new Placement();
    /** Origin of {@link #onB}, where its forces act: {x, y, z}, metres, world frame. */
    final double[] point = new double[3];
    /** Scratch vectors. */
    final double[] first = new double[3];
    final double[] second = new double[3];
    /** Sums over the substeps of a step: impulses on the second body, N s and N m s, world frame. */
    private final double[] wrench = new double[6];
    private double breakingForce = Double.POSITIVE_INFINITY;
    private boolean broken;

    /**
     * @param a first body; null for the world
     * @param b second body; null for the world
     */
    Joint(JointedBody a, JointedBody b) {
        this.a = a == null ? WORLD : a;
        this.b = b == null ? WORLD : b;
        ends = new JointedBody[] {this.a, this.b};
    }

    /** Bodies on which its rows act. Not a copy. */
    JointedBody[] ends() {
        return ends;
    }

    /**
     * Fixes the joint's frame in both bodies at their present poses.
     * @param frame in the world
     */
    public final void attach(Pose frame) {
        attach(frame, frame);
    }

    /** Fixes a frame in each body at their present poses; both are in the world. */
    public final void attach(Pose frameOnA, Pose frameOnB) {
        attach(frameOnA, a, ownA);
        attach(frameOnB, b, ownB);
        broken = false;
        follow();
        restart();
    }

    private static void attach(Pose frame, JointedBody to, Placement own) {
        Placement at = to.place;
        Placement f = new Placement();
        f.setRotation(frame.qx, frame.qy, frame.qz, frame.qw);
        double[] origin = new double[3];
        at.toFrame(frame.x, frame.y, frame.z, origin, 0);
        own.x = origin[0];
        own.y = origin[1];
        own.z = origin[2];
        own.m00 = at.m00 * f.m00 + at.m10 * f.m10 + at.m20 * f.m20;
        own.m01 = at.m00 * f.m01 + at.m10 * f.m11 + at.m20 * f.m21;
        own.m02 = at.m00 * f.m02 + at.m10 * f.m12 + at.m20 * f.m22;
        own.m10 = at.m01 * f.m00 + at.m11 * f.m10 + at.m21 * f.m20;
        own.m11 = at.m01 * f.m01 + at.m11 * f.m11 + at.m21 * f.m21;
        own.m12 = at.m01 * f.m02 + at.m11 * f.m12 + at.m21 * f.m22;
        own.m20 = at.m02 * f.m00 + at.m12 * f.m10 + at.m22 * f.m20;
        own.m21 = at.m02 * f.m01 + at.m12 * f.m11 + at.m22 * f.m21;
        own.m22 = at.m02 * f.m02 + at.m12 * f.m12 + at.m22 * f.m22;
    }

    /** Updates the frames after the bodies have moved. */
    final void follow() {
        place(ownA, a, onA);
        place(ownB, b, onB);
        point[0] = onB.x;
        point[1] = onB.y;
        point[2] = onB.z;
    }

    private static void place(Placement own, JointedBody body, Placement into) {
        into.m00 = own.m00;
        into.m01 = own.m01;
        into.m02 = own.m02;
        into.m10 = own.m10;
        into.m11 = own.m11;
        into.m12 = own.m12;
        into.m20 = own.m20;
        into.m21 = own.m21;
        into.m22 = own.m22;
        into.x = own.x;
        into.y = own.y;
        into.z = own.z;
        into.within(body.place);
    }

    /** Number of its rows; it changes only with {@link #isStale}. */
    abstract int rows();

    /**
     * Sets up its rows, from number {@code at} on, with their position errors.
     * @param seconds length of the substep
     */
    abstract void fill(JointRows rows, int at, double seconds);

    /** Measures the position errors of its rows after the bodies have moved. */
    abstract void measure(JointRows rows, int at);

    /** Notes the impulses of a substep. */
    void note(JointRows rows, int at) {
    }

    /** Whether the number of its rows has changed. */
    boolean isStale() {
        return false;
    }

    /** Returns the axis of a servo; null without one. */
    JointAxis servo() {
        return null;
    }

    /** Number of the motor's row of a servo among its rows. */
    int servoRow() {
        return -1;
    }

    /** Forgets the motion before a restart. */
    void restart() {
        beginStep();
    }

    /** Begins a step. */
    void beginStep() {
        Arrays.fill(wrench, 0);
    }

    /** Ends a step. */
    void endStep(double seconds) {
    }

    /** Adds an impulse along a direction at {@link #point}, N s. */
    final void addForce(double[] n, double impulse) {
        for (int i = 0; i < 3; i++) {
            wrench[i] += impulse * n[i];
        }
    }

    /** Adds an angular impulse about a direction, N m s. */
    final void addTorque(double[] n, double impulse) {
        for (int i = 0; i < 3; i++) {
            wrench[3 + i] += impulse * n[i];
        }
    }

    /**
     * Copies the mean force and torque of the last step on the second body, at the joint.
     * @param into takes {fx, fy, fz, tx, ty, tz}, N and N m, world frame
     * @param seconds length of a step
     */
    public final void wrench(double[] into, double seconds) {
        for (int i = 0; i < wrench.length; i++) {
            into[i] = wrench[i] / seconds;
        }
    }

    /** Breaks the joint if its force in the last step was too large. */
    final void breakIfOverloaded(double seconds) {
        double square = wrench[0] * wrench[0] + wrench[1] * wrench[1] + wrench[2] * wrench[2];
        broken |= Math.sqrt(square) / seconds > breakingForce;
    }

    /** @param newtons force beyond which the joint breaks */
    public final void setBreakingForce(double newtons) {
        breakingForce = newtons;
    }

    /** Whether it has no effect any more. */
    public boolean isBroken() {
        return broken;
    }

    final JointedBody a() {
        return a;
    }

    final JointedBody b() {
        return b;
    }

    /** Copies an axis of a frame: 0 for x, 1 for y, 2 for z. */
    static void axis(Placement of, int number, double[] into) {
        into[0] = number == 0 ? of.m00 : number == 1 ? of.m01 : of.m02;
        into[1] = number == 0 ? of.m10 : number == 1 ? of.m11 : of.m12;
        into[2] = number == 0 ? of.m20 : number == 1 ? of.m21 : of.m22;
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
