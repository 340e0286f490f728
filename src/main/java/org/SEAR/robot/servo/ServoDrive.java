// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.servo;

import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.SEAR.POJOs.Servo;
import org.SEAR.devices.ServoHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.grammar.Parameter;
import org.SEAR.physics.joint.HingeJoint;
import org.SEAR.physics.joint.JointAxis;
import org.SEAR.project.ObjectPose;

/**
 * Servo that turns to a commanded angle. With shapes on it, it is a hinge with a motor in the physics. Its motor has
 * the linear characteristic of a small DC motor: torque = stallTorque (power - speed / no-load speed). It drives at
 * full power, brakes in time, and holds its angle up to its stall torque. Without shapes it turns at its speed.
 * Simulation thread.
 */
public final class ServoDrive implements ServoHardware {
    /** Number of overloaded steps in a row after which SEAR warns of a weight, and of a contact. */
    private static final int SINKS_FOR = 15;
    private static final int HELD_FOR = 20;
    /** Angle within which a servo has arrived, degrees. */
    private static final double ARRIVED = 1e-4;
    /** Angle within which an overloaded servo counts as arrived, degrees. */
    private static final double DEAD_BAND = 0.05;
    /** Angle of its end stops beyond its range, radians. */
    private static final double BEYOND = 1e-3;
    /** Speed above which a servo moves, rad/s. */
    private static final double MOVES = 1e-3;

    private final Servo object;
    private final String robot;
    private final Consumer<String> reported;
    private final BooleanSupplier holds;
    private final Pose axis;
    private final DeadTime delay;
    /** Hinge in the physics, and whether something touches its parts; null without shapes. */
    private HingeJoint hinge;
    private BooleanSupplier touched;
    /** Last command, and the one that takes effect, degrees. */
    private double commanded;
    private double wanted;
    private double angle;
    /** Angle of the parts, which follow the motor with play, degrees. */
    private double horn;
    /** Angle of the parts to which the motor turns its hinge, degrees. */
    private double target;
    /** Direction in which the motor takes the parts along; 0 while it crosses the play. */
    private double engaged;
    private boolean moves;
    /** Number of steps for which it has been overloaded. */
    private int held;
    private boolean complained;

    /**
     * Drive of a servo.
     *
     * @param told takes, once per run, a warning about a load that is too heavy
     * @param holds whether the robot holds an object, which stops a gripper by design
     */
    public ServoDrive(Servo object, String robot, Consumer<String> told, BooleanSupplier holds) {
        this.object = object;
        this.robot = robot;
        this.reported = told;
        this.holds = holds;
        this.axis = ObjectPose.of(object);
        delay = new DeadTime(object.getDelay());
        restart();
    }

    /**
     * Turns parts of the physics.
     * @param newHinge from the body that carries it to that of its parts
     * @param newTouched returns whether its parts touch something
     */
    public void setHinge(HingeJoint newHinge, BooleanSupplier newTouched) {
        hinge = newHinge;
        touched = newTouched;
    }

    /** Moves the servo to its start: 0 degrees, or the nearest legal angle. */
    public void restart() {
        wanted = Math.max(object.getMinAngle(), Math.min(object.getMaxAngle(), 0));
        angle = wanted;
        horn = wanted;
        target = wanted;
        engaged = 0;
        commanded = wanted;
        delay.restart(wanted);
        moves = false;
        held = 0;
        complained = false;
    }

    /**
     * Fixes its hinge in both bodies, which are at their start.
     * @param base pose of the body that carries it
     * @param link pose of the body of its parts
     */
    public void attach(Pose base, Pose link) {
        hinge.attach(base.times(axis), link.times(axis));
        JointAxis motor = hinge.getAxis();
        motor.begin(Math.toRadians(horn));
        motor.setLimits(Math.toRadians(object.getMinAngle()) - BEYOND,
            Math.toRadians(object.getMaxAngle()) + BEYOND, 0);
        motor.setMotor(object.getStallTorque(), Math.toRadians(object.getSpeed()), 1);
        motor.setLocking(object.isSelfLocking());
        motor.drive(JointAxis.Drive.SERVO, Math.toRadians(horn));
    }

    @Override
    public String getName() {
        return object.getName();
    }

    @Override
    public void setAngle(double degrees) {
        if (!(degrees >= object.getMinAngle() && degrees <= object.getMaxAngle())) {
            throw new IllegalArgumentException("servo " + object.getName() + " of robot " + robot + ": angle is "
                + degrees + ", legal: " + Parameter.format(object.getMinAngle()) + " to "
                + Parameter.format(object.getMaxAngle()) + " deg");
        }
        commanded = degrees;
    }

    /**
     * Begins a step: takes its command, and turns if it has no hinge.
     * @return whether it moves
     */
    public boolean step() {
        double before = wanted;
        wanted = delay.isUsed() ? delay.pass(commanded) : commanded;
        if (hinge == null) {
            moves = false;
            turnFreely();
            return moves;
        }
        boolean busy = moves || before != wanted || delay.isPending();
        if (object.getPlay() == 0) {
            target = wanted;
        } else {
            busy |= crossPlay();
        }
        hinge.getAxis().drive(JointAxis.Drive.SERVO, Math.toRadians(target));
        return busy;
    }

    /** Turns motor and parts without a load. */
    private void turnFreely() {
        double hornBefore = horn;
        turnMotor();
        horn = Math.max(angle - object.getPlay() / 2, Math.min(angle + object.getPlay() / 2, horn));
        moves = horn != hornBefore;
    }

    private void turnMotor() {
        double most = object.getSpeed() * TimeStep.SECONDS;
        angle = Math.abs(wanted - angle) <= most ? wanted : angle + Math.copySign(most, wanted - angle);
    }

    /** The motor turns freely through the play, then takes the parts along. Returns whether it turns freely. */
    private boolean crossPlay() {
        double ahead = Math.signum(wanted - angle);
        double half = object.getPlay() / 2;
        if (Math.abs(wanted - angle) < ARRIVED) {
            return false;
        }
        engaged = ahead * (angle - horn) >= half - ARRIVED ? ahead : 0;
        if (engaged != 0) {
            target = wanted - ahead * half;
            return false;
        }
        turnMotor();
        angle = Math.max(horn - half, Math.min(horn + half, angle));
        return true;
    }

    /** Takes over the angle of its hinge after a step. */
    public void follow() {
        if (hinge == null) {
            return;
        }
        JointAxis motor = hinge.getAxis();
        double half = object.getPlay() / 2;
        horn = Math.toDegrees(motor.getPosition());
        angle = engaged != 0 ? horn + engaged * half : Math.max(horn - half, Math.min(horn + half, angle));
        moves = Math.abs(motor.getSpeed()) > MOVES;
        held = motor.isOverloaded() && Math.abs(angle - wanted) > DEAD_BAND ? held + 1 : 0;
        if (held >= SINKS_FOR && !complained && !holds.getAsBoolean()
            && (held >= HELD_FOR || !touched.getAsBoolean())) {
            complained = true;
            report(Math.abs(motor.getLoad()));
        }
    }

    private void report(double load) {
        String name = object.getName();
        String torque = Parameter.format(object.getStallTorque());
        reported.accept(touched.getAsBoolean()
            ? String.format(Locale.ROOT, "servo %s of robot %s is blocked at %.1f deg, on its way to %.1f deg, by a"
                + " contact. If it should move on, give it more than its stallTorque of %s N m"
                + " (%s.setStallTorque(...))", name, robot, angle, wanted, torque, name)
            : String.format(Locale.ROOT, "servo %s of robot %s is too weak to turn its load to %.1f deg: at %.1f deg"
                + " the load pulls with %.3g N m, and its stallTorque is %s N m. Give it more (%s.setStallTorque(...)),"
                + " or mount less, nearer to its axis", name, robot, wanted, angle, load, torque, name));
    }

    /** Returns its rotation about its axis, in the frame of its own mount. */
    public Pose turn() {
        double half = Math.toRadians(horn) / 2;
        double[] along = axis.rotate(0, Math.sin(half), 0);
        Pose turned = new Pose(0, 0, 0, along[0], along[1], along[2], Math.cos(half));
        double[] moved = turned.rotate(axis.x, axis.y, axis.z);
        return new Pose(axis.x - moved[0], axis.y - moved[1], axis.z - moved[2],
            turned.qx, turned.qy, turned.qz, turned.qw);
    }

    @Override
    public double getAngle() {
        return Math.abs(angle - wanted) < ARRIVED ? wanted : angle;
    }

    /** Angle of the parts that it turns, degrees. */
    public double getHornAngle() {
        return horn;
    }

    @Override
    public double getMinAngle() {
        return object.getMinAngle();
    }

    @Override
    public double getMaxAngle() {
        return object.getMaxAngle();
    }
}
