package org.SEAR.physics.solid;

import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;

/**
 * An axis about which a motor turns solids of a body, a revolute joint: it goes as planned while its motor has the torque, and yields to what they
 * meet beyond that. The motor has the straight line of a DC motor: torque = stall torque (power - speed / no-load speed). In a step it keeps to the
 * plan by what is left of its power; what pushes more slows the hinge down, and the slower it is the more torque the motor has. Turning it back takes
 * more than the stall torque, for there is friction in its gears. Simulation thread.
 */
public final class Hinge {
    /** Friction of the gears when something turns them, as a share of the stall torque. */
    private static final double GEARS = 0.3;

    private Pose axis = Pose.IDENTITY;
    private double ux;
    private double uy;
    private double uz;
    /** Half of what it is to turn in this step, radians, and how much shorter a way straight across is than the arc. */
    private double half;
    private double chord = 1;
    private double stallTorque;
    /** Torque that is lost for each rad/s, N m s. */
    private double damping;
    /** Of what is on it, kg m^2, and of that with what damps it in a substep, which counts as if it were inertia: so it is stable. */
    private double load;
    private double inertia = 1;
    /** Speed, rad/s. */
    private double planned;
    /** Share of the motor's power that the plan takes, -1 to 1. */
    private double power;
    private double seconds = TimeStep.SECONDS;
    /** How much faster than planned it turns, rad/s, and how much farther it has come in this step, radians. */
    private double deviation;
    private double ahead;
    /** Angular impulses of this substep, Nms: with which the motor keeps to the plan, and the gears from turning back. */
    private double held;
    private double braked;

    /**
     * A step begins.
     *
     * @param at where it is in the body's frame; it turns about its y axis
     * @param torque with which its motor stalls, N m
     * @param fastest speed of its motor without load, rad/s
     * @param mass moment of inertia of what it turns, kg m^2
     * @param turning how far it is to turn in this step, radians
     * @param used share of the power that the plan takes, -1 to 1, + to turn counter-clockwise seen from above
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

    /** Back to the start: nothing is kept from the steps before. */
    public void restart() {
        deviation = 0;
        ahead = 0;
        held = 0;
        braked = 0;
    }

    /** How much faster it turns than planned, rad/s. */
    public double deviation() {
        return deviation;
    }

    /** How much farther it has come in this step than planned, radians. */
    public double ahead() {
        return ahead;
    }

    /** The solver begins with a step, whose substeps are about so long, seconds. */
    public void prepare(double substep) {
        inertia = load + substep * damping;
    }

    /** A substep begins. */
    public void begin(double newSeconds) {
        double scale = newSeconds / seconds;
        seconds = newSeconds;
        held *= scale;
        braked *= scale;
        deviation = (deviation * load + held + braked) / inertia;
    }

    /** One pass of the motor, which keeps to the plan, and of the gears. */
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

    /** The substep ends. */
    public void advance() {
        ahead += deviation * seconds;
    }

    /** What is on it is pushed against its turning by an impulse, Ns, with a lever, metres. */
    public void push(double lever, double impulse) {
        deviation -= lever * impulse / inertia;
    }

    /** Speed that what is on it gives way for an impulse of 1 Ns at a lever, metres: 1/kg. */
    public double yields(double lever) {
        return lever * lever / inertia;
    }

    /**
     * How far a point of what is on it goes along a direction when it turns by 1 rad, metres: straight across, as {@link InnerMotion#speed} counts
     * in a step, so that a hinge that is held stands still.
     *
     * @param body where the body's centre of mass is and how it is turned
     * @param d has a unit direction, world frame, three numbers from {@code i} on
     * @param x of the point from the body's origin, body frame, metres, likewise y and z
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
        return InnerMotion.along(body, d, i, along * wx + inwards * (uy * wz - uz * wy), along * wy + inwards * (uz * wx - ux * wz),
            along * wz + inwards * (ux * wy - uy * wx));
    }
}
