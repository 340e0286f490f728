// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.SolverBody;

/**
 * Inertia of one wheel about its axle. The robot takes the reaction: a motor that speeds a wheel up turns its robot the
 * other way. Speeds are those of the rim along the driving direction, relative to the robot, m/s. Simulation thread.
 */
final class Rim {
    /** Density of a solid disc that weighs as much as a hobby wheel of that size, kg/m^3. */
    private static final double DENSITY = 300;
    /** Largest mass of a wheel without a given one, and of any wheel, as a share of its robot's. */
    private static final double USUAL = 0.05;
    private static final double MOST = 0.2;

    /** Mass at the rim with the same inertia, kg; 0 without one: a ball, or a caster. */
    final double mass;
    private final double reach;
    private final Vec3 axle = new Vec3();
    /** Null while the robot sleeps. */
    private SolverBody body;
    private double before;
    private double speed;
    private double reaction;

    /**
     * @param reach distance along the driving direction per radian, metres
     * @param robot mass of the robot, kg
     */
    Rim(Wheel wheel, WheelShape shape, double reach, double robot) {
        this.reach = reach;
        double usual = Math.min(USUAL * robot, DENSITY * Math.PI * shape.radius * shape.radius * 2 * shape.half);
        double weight = wheel.getMass() > 0 ? Math.min(MOST * robot, wheel.getMass()) : usual;
        mass = wheel.getType() == Wheel.IDLER ? 0 : weight / 2 * (shape.radius / reach) * (shape.radius / reach);
    }

    /**
     * Begins a substep.
     * @param up of the robot, world frame
     * @param ahead rolling direction, world frame
     */
    void begin(SolverBody newBody, Vec3 up, Vec3 ahead) {
        body = newBody;
        axle.cross(up, ahead);
        before = speed;
        reaction = 0;
    }

    /** Ends the step of a robot that falls asleep: it takes no further reaction. */
    void rest() {
        body = null;
    }

    /** Speed at the start of the substep. */
    double before() {
        return before;
    }

    /** Speed at the end of the substep. */
    double speed() {
        return speed;
    }

    /** Impulse at the rim that its change of speed in this substep takes, N s. */
    double reaction() {
        return reaction;
    }

    /** Turns at a speed at the end of the substep; the robot takes the reaction. */
    void turn(double newSpeed) {
        speed = newSpeed;
        if (mass > 0 && body != null) {
            reaction = mass * (speed - before);
            double twist = -reaction * reach;
            body.twist(twist * axle.x, twist * axle.y, twist * axle.z);
        }
    }

    /** Turns in the air. */
    void turnFreely(double newSpeed) {
        turn(newSpeed);
        if (reaction != 0) {
            body.hold();
        }
    }
}
