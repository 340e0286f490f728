package org.SEAR.devices;

/** A motor of a robot as firmware and scripts see it. Simulation thread only. */
public interface MotorHardware {
    /** Its name, as that of its object. */
    String getName();

    /**
     * Gives it power until the next command; 0 shorts it, so that it brakes.
     *
     * @param power share of the full voltage, -1 to 1, + forward
     * @throws IllegalArgumentException that names the motor, the value and the legal range
     */
    void setPower(double power);

    /**
     * Has its controller hold a speed, with whatever power it takes, until the next command.
     *
     * @param speed of the wheels, rad/s, + forward; at most what they reach without load
     * @throws IllegalArgumentException that names the motor, the value and the legal range
     */
    void setSpeed(double speed);

    /** Mean speed of its wheels, rad/s, + forward. */
    double getSpeed();

    /** What its encoder has counted since start or reset, + forward; 0 without an encoder. */
    long getCounts();

    /** Torque of its shaft now, as a share of the stall torque, -1 to 1. */
    double getLoad();
}
