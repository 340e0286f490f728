// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.List;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.devices.RobotHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.Truth;

/** Robot of the world: body, wheels, sensors, devices. Simulation thread only. */
public interface Robot {
    /** Its object; immutable. */
    SEARrobot getObject();

    /** Number of the robot, which owns its shapes in the beam scene. */
    int getOwner();

    Pose getPose();

    /** Pose after a start or reset. */
    Pose getStart();

    /**
     * Its object with the start pose of its file: {@link #getObject} until the robot is moved. Only its pose is valid.
     * Immutable.
     */
    SEARrobot getWritten();

    Truth getTruth();

    RobotHardware getHardware();

    List<Sensor<?>> getSensors();

    /** Centre of mass and tipping angle, with its servos at their start. */
    Stability getStability();

    /**
     * Drives as the Roomba command does. A robot with steered wheels steers to that circle, or as far as it can, unless
     * a servo steers. Straight on it keeps the angle set by {@link #steer}.
     * @param speed m/s
     * @param radius metres, positive to the left, infinite = straight, 0 = in place to the left
     */
    void drive(double speed, double radius);

    /**
     * Steers by its steered wheels.
     * @param degrees of a wheel in the middle between left and right, + to the left
     * @throws IllegalArgumentException if it has none, if a servo steers them, or if the angle is out of range
     */
    void steer(double degrees);

    /** Present steering angle, degrees, + to the left; 0 without steered wheels. */
    double getSteering();
}
