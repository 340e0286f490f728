// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;

/**
 * Revolute joint: a motor turns solids of a body about an axis. It follows the plan while the motor has enough torque,
 * and yields to contacts beyond that. The motor has the linear characteristic of a DC motor: torque = stall torque
 * (power - speed / no-load speed). The plan holds within the remaining power. A larger load slows the hinge down, and
 * the motor's torque rises. Turning the hinge back takes more than the stall torque because of friction in the gears.
 * Simulation thread.
 */
public final class Hinge {
    /** Friction of back-driven gears, as a share of the stall torque. */
    private static final double GEARS = 0.3;

    private Pose axis = Pose.IDENTITY;
    private double ux;
    private double uy;
    private double uz;
    /** Half of the planned rotation of this step, radians, and the ratio of chord to arc. */
    private double half;
    private double chord = 1;
    private double stallTorque;
    /** Torque lost per rad/s, N m s. */
    private double damping;
    /** Inertia of the load, kg m^2, and with damping over a substep added as inertia (implicit, hence stable). */
    private double load;
    private double inertia = 1;
    /** Planned speed, rad/s. */
    private double planned;
    /** Share of the motor's power for the plan, -1 to 1. */
    private double power;
    private double seconds = TimeStep.SECONDS;
    /** Speed beyond the plan, rad/s, and angle beyond the plan in this step, radians. */
    private double deviation;
    private double ahead;
    /** Angular impulses of this substep, N m s: of the motor, and of the gears against turning back. */
    private double held;
    private double braked;

    /**
     * Begins a step.
     * @param at pose in the body's frame; the hinge turns about its y axis
     * @param torque stall torque of the motor, N m
     * @param fastest no-load speed of the motor, rad/s
     * @param mass moment of inertia of the load, kg m^2
     * @param turning planned rotation in this step, radians
     * @param used share of the power for the plan, -1 to 1, + counter-clockwise seen from above
     */
    public void plan(Pose at, double torque, double fastest, double mass, double turning, double used) {
        axis = at;
        planned = turning / TimeStep.SECONDS;
        half = turning / 2;
        chord = half == 0 ? 1 : Math.sin(half) / half;
        stallTorque = torque;
        damping = torque / fastest;
        double[] up = at.rotate(0, 1, 0);
        ux = up[0];
        uy = up[1];
        uz = up[2];
        load = mass;
        power = Math.max(-1, Math.min(1, used));
        deviation = 0;
        ahead = 0;
    }

    /** Clears all state of former steps. */
    public void restart() {
        deviation = 0;
        ahead = 0;
        held = 0;
        braked = 0;
    }

    /** Speed beyond the plan, rad/s. */
    public double deviation() {
        return deviation;
    }

    /** Angle beyond the plan in this step, radians. */
    public double ahead() {
        return ahead;
    }

    /** Prepares a step with substeps of about this length, seconds. */
    public void prepare(double substep) {
        inertia = load + substep * damping;
    }

    /** Begins a substep. */
    public void begin(double newSeconds) {
        double scale = newSeconds / seconds;
        seconds = newSeconds;
        held *= scale;
        braked *= scale;
        deviation = (deviation * load + held + braked) / inertia;
    }

    /** Solves one pass of motor and gears. */
    public void solve() {
        double most = stallTorque * seconds;
        double sum = Math.max(-most * (1 + power), Math.min(most * (1 - power), held - deviation * inertia));
        deviation += (sum - held) / inertia;
        held = sum;
        double brake = braked - (planned + deviation) * inertia;
        sum = planned > 0 ? Math.max(0, Math.min(GEARS * most, brake)) : Math.min(0, Math.max(-GEARS * most, brake));
        deviation += (sum - braked) / inertia;
        braked = sum;
    }

    /** Ends the substep. */
    public void advance() {
        ahead += deviation * seconds;
    }

    /** Applies an impulse against the rotation, N s, at a lever, metres. */
    public void push(double lever, double impulse) {
        deviation -= lever * impulse / inertia;
    }

    /** Returns the speed of the load per impulse of 1 N s at a lever in metres, 1/kg. */
    public double yields(double lever) {
        return lever * lever / inertia;
    }

    /**
     * Returns the displacement of a point of the load along a direction, metres per radian. It is that of the chord,
     * consistent with {@link InnerMotion#speed}, so that a held hinge stands still.
     * @param body pose of the body's centre of mass
     * @param d holds a unit direction, world frame, three numbers from {@code i} on
     * @param x of the point in the body's frame, metres, likewise y and z
     */
    double lever(Placement body, double[] d, int i, double x, double y, double z) {
        double rx = x - axis.x;
        double ry = y - axis.y;
        double rz = z - axis.z;
        double wx = uy * rz - uz * ry;
        double wy = uz * rx - ux * rz;
        double wz = ux * ry - uy * rx;
        double along = chord * Math.cos(half);
        double inwards = chord * Math.sin(half);
        return InnerMotion.along(body, d, i, along * wx + inwards * (uy * wz - uz * wy), along * wy
            + inwards * (uz * wx - ux * wz),
            along * wz + inwards * (ux * wy - uy * wx));
    }
}
