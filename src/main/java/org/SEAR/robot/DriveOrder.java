// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.Arrays;
import org.SEAR.POJOs.Wheel;

/**
 * Checked drive command of a script: {@code driveStraight}, {@code spin}, {@code setWheelSpeeds}, {@code drive} or
 * {@code driveVelocity}. Immutable, any thread.
 */
public final class DriveOrder {
    /** Largest wheel speed over ground, m/s. */
    private static final double MAX_SPEED = 100;
    /** Largest turn rate of a robot, degrees per second. */
    private static final double MAX_SPIN = 3600;
    private static final String ALL_IN_THE_MIDDLE = ": all its driven wheels are in the middle. Move them apart with "
        + "wheel.move(x, y, z): x > 0 is left, x < 0 is right";

    /** Name of the call, and its values as text. */
    public final String call;
    public final String values;
    /** Whether it lets the robot move. */
    public final boolean moves;
    /** Whether the values are the speeds of both sides, not speed and radius of a circle. */
    public final boolean wheels;
    /** Whether the first value is the turn rate of a robot that turns in place, degrees per second. */
    private final boolean inPlace;
    private final double first;
    private final double second;

    private DriveOrder(String call, boolean wheels, double first, double second, double... values) {
        this(call, wheels, false, first, second, values);
    }

    private DriveOrder(String call, boolean wheels, boolean inPlace, double first, double second, double... values) {
        this.call = call;
        this.inPlace = inPlace;
        this.values = Arrays.toString(values);
        this.moves = first != 0 || wheels && second != 0;
        this.wheels = wheels;
        this.first = first;
        this.second = second;
    }

    /** @param speed m/s, + forward */
    public static DriveOrder straight(double speed) {
        check("driveStraight: speed", speed, MAX_SPEED, "m/s");
        return new DriveOrder("driveStraight", true, speed, speed, speed);
    }

    /** @param degrees per second, + to the left */
    public static DriveOrder spin(double degrees) {
        check("spin: speed", degrees, MAX_SPIN, "degrees per second");
        return new DriveOrder("spin", false, true, degrees, 0, degrees);
    }

    /** @param left m/s over ground, + forward, likewise right */
    public static DriveOrder wheels(double left, double right) {
        check("setWheelSpeeds: left", left, MAX_SPEED, "m/s");
        check("setWheelSpeeds: right", right, MAX_SPEED, "m/s");
        return new DriveOrder("setWheelSpeeds", true, left, right, left, right);
    }

    /**
     * Returns a command to drive along a circle.
     * @param speed m/s
     * @param radius metres, + left, infinite = straight, 0 = in place
     */
    public static DriveOrder circle(double speed, double radius) {
        check("drive: speed", speed, MAX_SPEED, "m/s");
        if (Double.isNaN(radius)) {
            throw new IllegalArgumentException("drive: radius is " + radius + ", legal: metres, + to the left, "
                + "0 or infinity");
        }
        return new DriveOrder("drive", false, speed, radius, speed, radius);
    }

    /**
     * Returns a command to drive at a speed and a turn rate, as a ROS Twist has them.
     * @param speed m/s, + forward
     * @param degrees per second, + to the left
     */
    public static DriveOrder velocity(double speed, double degrees) {
        check("driveVelocity: speed", speed, MAX_SPEED, "m/s");
        check("driveVelocity: turn rate", degrees, MAX_SPIN, "degrees per second");
        String call = "driveVelocity";
        if (speed == 0 && degrees != 0) {
            return new DriveOrder(call, false, true, degrees, 0, speed, degrees);
        }
        double radius = degrees == 0 ? Double.POSITIVE_INFINITY : speed / Math.toRadians(degrees);
        return new DriveOrder(call, false, speed, radius, speed, degrees);
    }

    private static void check(String what, double value, double most, String unit) {
        if (!(Math.abs(value) <= most)) {
            throw new IllegalArgumentException(what + " is " + value + ", legal: " + -most + " to " + most
                + " " + unit);
        }
    }

    /**
     * Returns the speed of the left side, or along the circle, m/s.
     * @throws IllegalArgumentException if the robot can't do that; the message has the remedy
     */
    public double getFirst(Robot driven) {
        String name = driven.getObject().getName();
        checkWheels(driven, wheels ? first : 0, wheels ? second : 0);
        if (!inPlace) {
            return first;
        }
        double base = driven.getHardware().getTrack();
        if (base == 0) {
            throw new IllegalArgumentException("robot " + name + " can't turn in place" + ALL_IN_THE_MIDDLE);
        }
        return Math.toRadians(first) * base / 2;
    }

    /**
     * Checks whether a robot's driven wheels can have these speeds.
     *
     * @param left m/s, likewise right
     * @throws IllegalArgumentException without driven wheels, or for different speeds if all are in the middle or a
     * servo
     *     steers; the message has the remedy
     */
    public static void checkWheels(Robot driven, double left, double right) {
        String name = driven.getObject().getName();
        if (driven.getHardware().getWheelRadius() == 0) {
            throw new IllegalArgumentException("robot " + name + " has no driven wheels: robot.addWheel(Wheel(name, "
                + "radius, width, 1)) adds one");
        }
        if (left == right) {
            return;
        }
        String refused = "robot " + name + " can't turn by wheel speeds " + left + " and " + right + " m/s";
        if (driven.getHardware().getTrack() == 0) {
            throw new IllegalArgumentException(refused + ALL_IN_THE_MIDDLE);
        }
        for (Wheel wheel : driven.getObject().getWheels()) {
            if (wheel.getSteeringServo() != null) {
                throw new IllegalArgumentException(refused + ": its servo " + wheel.getSteeringServo()
                    + " steers it. Turn that servo instead");
            }
        }
    }

    /** Returns the speed of the right side, m/s, or the radius of the circle, metres. */
    public double getSecond() {
        return second;
    }
}
