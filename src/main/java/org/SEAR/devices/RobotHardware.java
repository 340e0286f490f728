// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

/** Motors and contact sensors of one robot, for its firmware, at the current step. Simulation thread only. */
public interface RobotHardware {
    /**
     * Sets the speeds of the left and right driven wheels over ground, m/s; a servo with limited force reaches them. A
     * robot with steered wheels steers to the circle of different speeds, or as far as it can, unless a servo steers.
     */
    void setWheelSpeeds(double left, double right);

    /**
     * Stops the driven wheels as fast as possible without tipping the robot over, without the ramp of
     * {@link #setWheelSpeeds}.
     */
    void brake();

    /**
     * Finds a motor by the name of its object; always the same instance.
     *
     * @return null if the robot has no such motor
     */
    MotorHardware getMotor(String name);

    /**
     * Finds a servo by the name of its object; always the same instance.
     *
     * @return null if the robot has no such servo
     */
    ServoHardware getServo(String name);

    /**
     * Finds a light by the name of its object; always the same instance.
     *
     * @return null if the robot has no such light
     */
    LightHardware getLight(String name);

    /** Nominal distance between the left and right driven wheels, metres. */
    double getTrack();

    /** Rotation of the left driven wheels since start or reset by their encoders, radians, + forward. */
    double getLeftWheelAngle();

    /** Rotation of the right driven wheels since start or reset by their encoders, radians, + forward. */
    double getRightWheelAngle();

    /** Nominal radius of the driven wheels, metres. */
    double getWheelRadius();

    /** Force that the left wheel needs now, as a share of the motor's maximum, 0 to 1 (1: stalled). */
    double getLeftLoad();

    /** Force that the right wheel needs now, as a share of the motor's maximum, 0 to 1 (1: stalled). */
    double getRightLoad();

    /**
     * Signed distance travelled by the robot's centre since start or reset, metres, + forward; vibration does not add
     * to it.
     */
    double getPath();

    /** Speed of the body's middle along its forward axis, m/s. */
    double getSpeed();

    /** Heading turned since start or reset, radians, + counter-clockwise seen from above; not wrapped. */
    double getTurned();

    /** Whether something touches the front left quarter of the body (bumper). */
    boolean isBumpedLeft();

    /** Whether something touches the front right quarter of the body (bumper). */
    boolean isBumpedRight();

    /**
     * Whether the left wheel hangs in its suspension without ground; false while the robot settles at its start, up to
     * a second.
     */
    boolean isLeftWheelDropped();

    /**
     * Whether the right wheel hangs in its suspension without ground; false while the robot settles at its start, up to
     * a second.
     */
    boolean isRightWheelDropped();

    /** Whether the front idler hangs without ground; false while the robot settles at its start, up to a second. */
    boolean isCasterDropped();

    /**
     * Measures the distance along a ray in the body frame to the first object other than the robot, metres; infinity
     * beyond the range.
     *
     * @param x origin of the ray, body frame, metres, likewise y, z; (dx, dy, dz) unit vector in the body frame
     */
    double look(double x, double y, double z, double dx, double dy, double dz, double range);

    /** Radius of the body about its vertical axis, metres. */
    double getBodyRadius();

    /** Distance of the foremost axle ahead of the body's middle, metres. */
    double getFrontAxle();

    /**
     * Whether the robot is in the beam of a virtual wall: an environment object whose name begins with
     * {@code virtualWall}. The beam points along the object's forward axis (+Z), 20 degrees wide and 2.4 m long, with a
     * halo of 0.4 m around the object.
     */
    boolean isInVirtualWall();
}
