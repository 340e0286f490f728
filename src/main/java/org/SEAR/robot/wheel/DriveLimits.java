// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.SEAR.geometry.TimeStep;

/**
 * Commanded wheel speeds of a robot. Limits commands beyond its abilities, with one warning per kind, and approaches
 * them as fast as the robot can without tipping over. Simulation thread.
 */
final class DriveLimits {
    /** Relative excess above the limit that needs no warning. */
    private static final double TOLERANCE = 1e-6;

    private final String robot;
    private final List<RaycastWheel> wheels;
    private final DriveForces forces;
    private final Consumer<String> reported;
    private boolean reportedFast;
    private boolean reportedTight;
    private boolean reportedSliding;
    private boolean braking;
    private double left;
    private double right;
    private double commandedLeft;
    private double commandedRight;

    /** @param told takes warnings with the actual behaviour */
    DriveLimits(String robot, List<RaycastWheel> wheels, DriveForces forces, Consumer<String> told) {
        this.robot = robot;
        this.wheels = wheels;
        this.forces = forces;
        this.reported = told;
    }

    /**
     * @param newLeft m/s over ground, likewise newRight; both are scaled down to the motors' limit, which keeps the arc
     */
    void set(double newLeft, double newRight) {
        double share = share(newLeft, newRight);
        commandedLeft = share * newLeft;
        commandedRight = share * newRight;
        reportSliding((commandedLeft + commandedRight) / 2, turn(commandedLeft, commandedRight));
        braking = braking && newLeft == 0 && newRight == 0;
    }

    /** Starts an emergency stop, until the next command that moves. */
    void brake() {
        set(0, 0);
        braking = true;
    }

    private double share(double newLeft, double newRight) {
        double share = 1;
        for (int i = 0; i < wheels.size(); i++) {
            WheelMotor motor = wheels.get(i).getMotor();
            double wanted = Math.abs((newLeft + newRight) / 2 - turn(newLeft, newRight) * wheels.get(i).x);
            if (motor != null && wanted * share > motor.fastest()) {
                share = motor.fastest() / wanted;
            }
        }
        double fastest = Math.max(Math.abs(newLeft), Math.abs(newRight));
        if (share < 1 - TOLERANCE && !reportedFast) {
            reportedFast = true;
            reported.accept(String.format(Locale.ROOT, "robot %s can't obey the command to turn its wheels at %.2f "
                + "m/s: without load its motors"
                + " reach %.2f m/s, so it drives that fast instead, or slower under load. A motor's noLoadSpeed "
                + "sets its limit", robot, fastest,
                share * fastest));
        }
        return share;
    }

    /**
     * Warns of a circle that is too tight.
     * @param radius metres, positive
     * @param steering of the robot, with its limits
     * @param speed m/s
     */
    void reportTight(double radius, Steering steering, double speed) {
        if (radius < steering.tightest() * (1 - TOLERANCE) && !reportedTight) {
            reportedTight = true;
            reported.accept(String.format(Locale.ROOT,
                "robot %s can't obey the command to turn %s: its wheels steer by %s degrees at most. At %.2f m/s"
                + " it drives on a circle of %.2f m radius instead, and turns at %.1f degrees per second", robot,
                radius == 0 ? "in place" : String.format(Locale.ROOT, "on a circle of %.2f m radius", radius),
                number(steering.getMost()),
                Math.abs(speed), steering.tightest(), Math.toDegrees(Math.abs(speed) / steering.tightest())));
        }
    }

    /**
     * Warns of a circle that is too fast for the grip of the wheels.
     * @param speed m/s
     * @param turn rad/s
     */
    void reportSliding(double speed, double turn) {
        double needed = Math.abs(speed * turn);
        double held = forces.gravity() * wheels.stream().filter(RaycastWheel::isGrounded)
            .mapToDouble(wheel -> wheel.getGrip().getFriction())
            .max().orElse(Double.POSITIVE_INFINITY);
        if (needed > held && !reportedSliding) {
            reportedSliding = true;
            reported.accept(String.format(Locale.ROOT,
                "robot %s can't obey the command to drive at %.2f m/s on a circle of %.2f m radius: that takes"
                + " %.1f m/s\u00b2 of grip, and here its wheels have %.1f. It slides outwards instead; drive slower or "
                + "on a wider circle", robot,
                Math.abs(speed), Math.abs(speed / turn), needed, held));
        }
    }

    private static String number(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
    }

    /** Warns that a servo steers, not drive commands. */
    void reportServo(String servo) {
        if (!reportedTight) {
            reportedTight = true;
            reported.accept("robot " + robot + " can't obey the command to drive on a circle, "
                + "because its servo " + servo
                + " steers it: it drives where the servo points."
                + " Turn it with sear.setServo(\"" + servo + "\", degrees)");
        }
    }

    /** Moves both speeds towards the commanded ones, in proportion, which keeps the arc. */
    void approach() {
        double largest = Math.max(Math.abs(commandedLeft - left), Math.abs(commandedRight - right));
        double step = forces.getRamp(braking) * TimeStep.SECONDS;
        double share = largest <= step ? 1 : step / largest;
        left = share == 1 ? commandedLeft : left + share * (commandedLeft - left);
        right = share == 1 ? commandedRight : right + share * (commandedRight - right);
    }

    /** Speed of the middle, m/s. */
    double middle() {
        return (left + right) / 2;
    }

    /** Turn rate due to the speeds of both sides, rad/s. */
    double turn() {
        return turn(left, right);
    }

    private double turn(double ofLeft, double ofRight) {
        return forces.track > DriveForces.NO_TRACK ? (ofRight - ofLeft) / forces.track : 0;
    }

    /** Whether a speed or a commanded speed is not 0. */
    boolean isCommanded() {
        return left != 0 || right != 0 || commandedLeft != 0 || commandedRight != 0;
    }
}
