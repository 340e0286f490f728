package org.SEAR.devices;

/** Motors and contact sensors of one robot as its firmware sees them, at the present step. Simulation thread only. */
public interface RobotHardware {
    /** Sets the speed of the left and right driven wheels over ground, m/s; a servo with limited force reaches it. */
    void setWheelSpeeds(double left, double right);

    /** Stops the driven wheels as fast as they may without tipping the robot over: no ramp as for {@link #setWheelSpeeds}. */
    void brake();

    /**
     * A motor by the name of its object; the same for ever.
     *
     * @return null if the robot has none of that name
     */
    MotorHardware getMotor(String name);

    /**
     * A servo by the name of its object; the same for ever.
     *
     * @return null if the robot has none of that name
     */
    ServoHardware getServo(String name);

    /**
     * A light by the name of its object; the same for ever.
     *
     * @return null if the robot has none of that name
     */
    LightHardware getLight(String name);

    /** Distance between left and right driven wheels, metres. */
    double getWheelBase();

    /** Angle turned by the left driven wheels since start or reset, radians, + forward. */
    double getLeftWheelAngle();

    /** Angle turned by the right driven wheels since start or reset, radians, + forward. */
    double getRightWheelAngle();

    /** Radius of the driven wheels, metres. */
    double getWheelRadius();

    /** Share of the greatest motor force that the left wheel needs now, 0 to 1 (1: stalled). */
    double getLeftLoad();

    /** Share of the greatest motor force that the right wheel needs now, 0 to 1 (1: stalled). */
    double getRightLoad();

    /** Signed path of the robot's centre since start or reset, metres, + forward; not clocked up by vibration. */
    double getPath();

    /** Heading turned since start or reset, radians, + counter-clockwise seen from above; not wrapped. */
    double getTurned();

    /** Whether something touches the front left quarter of the body (bumper). */
    boolean isBumpedLeft();

    /** Whether something touches the front right quarter of the body (bumper). */
    boolean isBumpedRight();

    /** Whether the left wheel hangs in its suspension without ground; not while the robot is let down at its start, up to a second. */
    boolean isLeftWheelDropped();

    /** Whether the right wheel hangs in its suspension without ground; not while the robot is let down at its start, up to a second. */
    boolean isRightWheelDropped();

    /** Whether the front idler hangs without ground; not while the robot is let down at its start, up to a second. */
    boolean isCasterDropped();

    /**
     * Distance from a point of the body along a direction of the body frame to what is there, not the robot itself; infinity beyond the range.
     *
     * @param x body frame, metres, likewise y, z; (dx, dy, dz) unit vector in the body frame
     */
    double look(double x, double y, double z, double dx, double dy, double dz, double range);

    /** Radius of the body about its vertical axis, metres. */
    double getBodyRadius();

    /** How far before the body's middle the axle of the foremost wheel is, metres. */
    double getFrontAxle();

    /**
     * Whether the robot stands in the beam of a virtual wall: an environment object whose name begins with {@code virtualWall}. Its beam is a fan
     * along the object's forward axis (+Z), 20 degrees wide and 2.4 m long, with a halo of 0.4 m around the object.
     */
    boolean isInVirtualWall();
}
