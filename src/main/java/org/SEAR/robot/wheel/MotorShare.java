// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.physics.ConstraintRow;

/**
 * One wheel's share of a motor. The line from stall torque to no-load speed is solved implicitly, together with the
 * ground's reaction. A commanded motor speed is the mean of its wheels: each gets the part that suits the steered
 * curve. Simulation thread.
 */
final class MotorShare implements WheelMotor {
    private final MotorDrive motor;
    private final double reach;
    private double following;
    private double part = 1;
    private double load;

    /** @param reach distance rolled per radian, metres */
    MotorShare(MotorDrive motor, double reach) {
        this.motor = motor;
        this.reach = reach;
    }

    @Override
    public void follow(double speed, double newPart) {
        following = speed;
        part = newPart;
    }

    double getPart() {
        return part;
    }

    @Override
    public boolean holds() {
        return motor.getOrder() != MotorDrive.Order.POWER && target() == 0;
    }

    @Override
    public double holding(double seconds) {
        return motor.stall(reach) * seconds;
    }

    @Override
    public void solve(ConstraintRow row, double[] v, double rolling, Rim rim, double grip, double seconds) {
        double stall = motor.stall(reach) * seconds;
        double braking = motor.slope(reach) * seconds;
        double soft = 1 + (braking + rim.mass) * row.mobility;
        double free = -braking * rolling - rim.mass * (rolling - rim.before()) - row.impulse;
        double change;
        if (motor.getOrder() == MotorDrive.Order.POWER) {
            change = (stall * motor.getPower() + free) / soft;
        } else {
            change = Math.max((free - stall) / soft,
                Math.min((free + stall) / soft, (target() - rolling) / row.mobility));
        }
        row.add(v, change, -grip, grip);
    }

    private double target() {
        return motor.getOrder() == MotorDrive.Order.SPEED ? motor.getCommanded() * reach * motor.share(part)
            : following;
    }

    @Override
    public void feel(double impulse, double rolled, boolean grounded, double seconds) {
        load = Math.max(-1, Math.min(1, impulse / (seconds * motor.stall(reach))));
    }

    @Override
    public double slipping(Rim rim, double impulse, double seconds) {
        double stall = motor.stall(reach) * seconds;
        double soft = rim.mass + motor.slope(reach) * seconds;
        double free = rim.mass * rim.before() - impulse;
        if (motor.getOrder() == MotorDrive.Order.POWER) {
            return (free + stall * motor.getPower()) / soft;
        }
        return Math.max((free - stall) / soft, Math.min((free + stall) / soft, target()));
    }

    @Override
    public double load() {
        return load;
    }

    @Override
    public double fastest() {
        return motor.fastest(reach);
    }
}
