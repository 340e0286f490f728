// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.servo;

import org.SEAR.POJOs.Motor;
import org.SEAR.physics.joint.JointAxis;

/**
 * Motor with gear that drives a joint of its robot. Speeds are rad/s of a hinge and m/s of a slider or rope. Before the
 * first command its power is 0, so that it brakes. Simulation thread.
 */
public final class JointMotor extends RobotMotor {
    private JointAxis axis;
    private Runnable wake;
    private double command;

    public JointMotor(Motor object, String robot) {
        super(object, robot);
    }

    /**
     * Connects it with its joint.
     * @param newWake wakes the bodies of the joint
     */
    public void connect(JointAxis newAxis, Runnable newWake) {
        axis = newAxis;
        wake = newWake;
    }

    /** Switches it on again; after the joint has been attached. */
    public void restart() {
        axis.setMotor(stall(), fastest(), 1);
        drive(JointAxis.Drive.POWER, 0);
    }

    private double stall() {
        return object.getStallTorque() * object.getGearRatio();
    }

    private double fastest() {
        return object.getNoLoadSpeed() / object.getGearRatio();
    }

    private void drive(JointAxis.Drive drive, double value) {
        command = value;
        axis.drive(drive, value);
        wake.run();
    }

    @Override
    public void setPower(double power) {
        drive(JointAxis.Drive.POWER, legal("power", power, 1, ""));
    }

    @Override
    public void setSpeed(double speed) {
        drive(JointAxis.Drive.SPEED, legal("speed", speed, fastest(),
            " rad/s, m/s of a slider or rope, which its joint reaches without load"));
    }

    /** Whether it has a command to move. */
    public boolean isCommanded() {
        return command != 0;
    }

    @Override
    public double getSpeed() {
        return axis.getSpeed();
    }

    @Override
    public long getCounts() {
        return (long) Math.floor(axis.getPosition() * object.getGearRatio() * object.getEncoderCounts()
            / (2 * Math.PI));
    }

    @Override
    public double getLoad() {
        return axis.getEffort() / stall();
    }
}
