// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

/** A motor of a robot, for firmware and scripts. Simulation thread only. */
public interface MotorHardware {
    /** Name of its object. */
    String getName();

    /**
     * Applies a voltage until the next command; 0 shorts the motor, which then brakes.
     *
     * @param power share of the full voltage, -1 to 1, + forward
     * @throws IllegalArgumentException that names the motor, the value and the legal range
     */
    void setPower(double power);

    /**
     * Lets the motor's controller hold a speed until the next command, with the power that this takes.
     *
     * @param speed of the wheels, rad/s, + forward; at most their no-load speed
     * @throws IllegalArgumentException that names the motor, the value and the legal range
     */
    void setSpeed(double speed);

    /** Mean speed of its wheels, rad/s, + forward. */
    double getSpeed();

    /** Encoder counts since start or reset, + forward; 0 without an encoder. */
    long getCounts();

    /** Torque of its shaft, as a share of the stall torque, -1 to 1. */
    double getLoad();
}
