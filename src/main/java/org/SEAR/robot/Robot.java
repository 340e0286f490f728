package org.SEAR.robot;

import java.util.List;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.devices.RobotHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.Truth;

/** One robot of the world: body, wheels, sensors, devices. Simulation thread only. */
public interface Robot {
    /** Its object; immutable. */
    SEARrobot getObject();

    /** Number of the robot, which owns its shapes in the beam scene. */
    int getOwner();

    Pose getPose();

    /** Where it is after a start or reset. */
    Pose getStart();

    /** Its object as its file said where it starts: {@link #getObject} until it was moved. Only its place counts. Immutable. */
    SEARrobot getWritten();

    Truth getTruth();

    RobotHardware getHardware();

    List<Sensor<?>> getSensors();

    /** Where its centre of mass is, and when it tips over, with its servos as they start. */
    Stability getStability();

    /**
     * Drives as the Roomba command does. A robot with steered wheels, unless a servo steers them, steers to that circle, or as far as it can;
     * straight on it keeps the angle that {@link #steer} has set.
     *
     * @param speed m/s
     * @param radius metres, positive to the left, infinite = straight, 0 = in place to the left
     */
    void drive(double speed, double radius);

    /**
     * Steers by its steered wheels.
     *
     * @param degrees of a wheel in the middle between left and right, + to the left
     * @throws IllegalArgumentException if it has none, or a servo steers them, or that is out of their range
     */
    void steer(double degrees);

    /** Where it steers now, degrees, + to the left; 0 without steered wheels. */
    double getSteering();
}
