package org.SEAR.robot;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.Parameter;
import org.SEAR.devices.MotorHardware;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.ConstraintRow;

/**
 * A motor and its gear. At a wheel that rolls at v over ground its force is a * power - b * v, a straight line from the stall torque to the speed
 * without load; with several wheels each has its share of it at its own speed. The line is solved implicitly, together with what the ground gives.
 * Simulation thread.
 */
final class MotorDrive implements MotorHardware {
    private enum Order { FOLLOW, POWER, SPEED }

    private final Motor object;
    private final String robot;
    private final List<RaycastWheel> wheels = new ArrayList<>();
    private Order order = Order.FOLLOW;
    private double power;
    private double speed;

    MotorDrive(Motor object, String robot) {
        this.object = object;
        this.robot = robot;
    }

    /** As at the start, on wheels that were made anew. */
    void restart(List<RaycastWheel> all) {
        wheels.clear();
        order = Order.FOLLOW;
        power = 0;
        speed = 0;
        for (RaycastWheel wheel : all) {
            if (object.getWheelNames().contains(wheel.object.getName())) {
                wheels.add(wheel);
                wheel.setMotor(this);
            }
        }
    }

    @Override
    public String getName() {
        return object.getName();
    }

    /** It has its wheels roll as the robot is told to drive, until it gets an order of its own. */
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
        speed = legal("speed", newSpeed, object.getNoLoadSpeed() / object.getGearRatio(), " rad/s, which its wheels reach without load");
        order = Order.SPEED;
    }

    private double legal(String what, double value, double most, String unit) {
        if (!(Math.abs(value) <= most)) {
            throw new IllegalArgumentException("motor " + object.getName() + " of robot " + robot + ": " + what + " is " + value + ", legal: "
                + Parameter.format(-most) + " to " + Parameter.format(most) + unit);
        }
        return value;
    }

    /** Whether it has an order of its own to move. */
    boolean isCommanded() {
        return order == Order.POWER && power != 0 || order == Order.SPEED && speed != 0;
    }

    /** How fast its wheels are told to turn, or would without load, rad/s; NaN if they follow the robot. */
    double getWanted() {
        return order == Order.FOLLOW ? Double.NaN : order == Order.SPEED ? speed : power * object.getNoLoadSpeed() / object.getGearRatio();
    }

    /**
     * One iteration for one of its wheels.
     *
     * @param row along which the wheel drives
     * @param rolling speed of the wheel over ground, m/s
     * @param following what the robot's drive wants that to be, m/s
     * @param reach metres that the wheel rolls for each radian
     * @param grip greatest impulse of the tyre, Ns
     */
    void solve(ConstraintRow row, double[] v, double rolling, double following, double reach, double grip) {
        double braking = TimeStep.SECONDS * slope(reach);
        double soft = 1 + braking * row.mobility;
        double least = (-TimeStep.SECONDS * stall(reach) - braking * rolling - row.impulse) / soft;
        double most = (TimeStep.SECONDS * stall(reach) - braking * rolling - row.impulse) / soft;
        double change;
        if (order == Order.POWER) {
            change = (TimeStep.SECONDS * stall(reach) * power - braking * rolling - row.impulse) / soft;
        } else {
            change = Math.max(least, Math.min(most, (target(following, reach) - rolling) / row.mobility));
        }
        row.add(v, change, -grip, grip);
    }

    private double target(double following, double reach) {
        return order == Order.SPEED ? speed * reach : following;
    }

    /**
     * How fast a wheel turns that slips, or hangs in the air.
     *
     * @param force that it gives to the ground, N
     * @return m/s at its rim
     */
    double slipping(double force, double following, double reach) {
        if (order == Order.POWER) {
            return (stall(reach) * power - force) / slope(reach);
        }
        double least = (-stall(reach) - force) / slope(reach);
        double most = (stall(reach) - force) / slope(reach);
        return Math.max(least, Math.min(most, target(following, reach)));
    }

    /** Greatest force of one wheel at full power and standstill, N. */
    double stall(double reach) {
        return object.getStallTorque() * object.getGearRatio() / (wheels.size() * reach);
    }

    /** How much less that is for each m/s, N s/m. */
    private double slope(double reach) {
        return stall(reach) * object.getGearRatio() / (object.getNoLoadSpeed() * reach);
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
            sum += wheel.getAngle();
        }
        return (long) Math.floor(sum / wheels.size() * object.getGearRatio() * object.getEncoderCounts() / (2 * Math.PI));
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
