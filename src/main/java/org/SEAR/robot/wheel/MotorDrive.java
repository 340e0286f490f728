// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Motor;
import org.SEAR.robot.servo.RobotMotor;

/**
 * Motor with gear. The force at a wheel that rolls at v over ground is a * power - b * v, a line from stall torque to
 * no-load speed. Several wheels share it, each at its own speed, see {@link MotorShare}. Simulation thread.
 */
public final class MotorDrive extends RobotMotor {
    private static final double MIN_PART = 1e-6;

    enum Order { FOLLOW, POWER, SPEED }

    private final List<RaycastWheel> wheels = new ArrayList<>();
    private final List<MotorShare> shares = new ArrayList<>();
    private Order order = Order.FOLLOW;
    private double power;
    private double speed;

    public MotorDrive(Motor object, String robot) {
        super(object, robot);
    }

    /** Resets the motor on new wheels. */
    void restart(List<RaycastWheel> all) {
        wheels.clear();
        shares.clear();
        order = Order.FOLLOW;
        power = 0;
        speed = 0;
        for (RaycastWheel wheel : all) {
            if (object.getWheelNames().contains(wheel.object.getName())) {
                wheels.add(wheel);
                shares.add(new MotorShare(this, wheel.reach));
                wheel.setMotor(shares.get(shares.size() - 1));
            }
        }
    }

    /** Makes the wheels follow the robot's drive command, until the motor gets its own. */
    void follow() {
        order = Order.FOLLOW;
    }

    @Override
    public void setPower(double newPower) {
        power = legal("power", newPower, 1, "");
        order = Order.POWER;
    }

    @Override
    public void setSpeed(double newSpeed) {
        speed = legal("speed", newSpeed, object.getNoLoadSpeed() / object.getGearRatio(),
            " rad/s, which its wheels reach without load");
        order = Order.SPEED;
    }

    /** Whether it has its own command to move. */
    boolean isCommanded() {
        return order == Order.POWER && power != 0 || order == Order.SPEED && speed != 0;
    }

    /** Commanded or no-load speed of its wheels, rad/s; NaN if they follow the robot. */
    double getWanted() {
        return order == Order.FOLLOW ? Double.NaN : order == Order.SPEED ? speed
            : power * object.getNoLoadSpeed() / object.getGearRatio();
    }

    Order getOrder() {
        return order;
    }

    /**
     * Returns the commanded or no-load speed of its wheels, m/s over ground, + forward.
     * @param robot commanded speed of the robot, which they may follow
     */
    double getAlong(double robot) {
        double wanted = getWanted();
        return Double.isNaN(wanted) ? robot : wheels.isEmpty() ? 0 : wanted * wheels.get(0).radius;
    }

    /** Commanded share of the voltage, -1 to 1. */
    double getPower() {
        return power;
    }

    /** Commanded mean speed of its wheels, rad/s. */
    double getCommanded() {
        return speed;
    }

    /**
     * Returns the rotation of a wheel per rotation of the mean, if it rolls {@code part} metres per metre of the
     * robot's middle.
     */
    double share(double part) {
        double sum = 0;
        for (int i = 0; i < shares.size(); i++) {
            sum += shares.get(i).getPart();
        }
        return Math.abs(sum) < MIN_PART ? 1 : part * shares.size() / sum;
    }

    /** Returns the greatest force of one wheel at full power and standstill, N. */
    double stall(double reach) {
        return object.getStallTorque() * object.getGearRatio() / (wheels.size() * reach);
    }

    /** Returns the loss of this force per m/s, N s/m. */
    double slope(double reach) {
        return stall(reach) / fastest(reach);
    }

    /** Returns the speed of its wheels at full power without load, m/s. */
    double fastest(double reach) {
        return object.getNoLoadSpeed() * reach / object.getGearRatio();
    }

    @Override
    public double getSpeed() {
        double sum = 0;
        for (RaycastWheel wheel : wheels) {
            sum += wheel.getSpin();
        }
        return sum / wheels.size();
    }

    @Override
    public long getCounts() {
        double sum = 0;
        for (RaycastWheel wheel : wheels) {
            sum += wheel.getEncoder();
        }
        return (long) Math.floor(sum / wheels.size() * object.getGearRatio() * object.getEncoderCounts() / (
            2 * Math.PI));
    }

    @Override
    public double getLoad() {
        double sum = 0;
        for (RaycastWheel wheel : wheels) {
            sum += wheel.getLoad();
        }
        return sum / wheels.size();
    }
}
