// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.physics.ConstraintRow;

/**
 * Motor of one driven wheel. Speeds are those of the wheel over ground along its driving direction, m/s. Simulation
 * thread.
 */
interface WheelMotor {
    /**
     * Sets the target of a drive command.
     * @param speed of the wheel, unless the motor has its own command
     * @param part speed of the wheel per m/s of the robot's middle, as steered
     */
    void follow(double speed, double part);

    /** Whether it holds the wheel where it is. */
    boolean holds();

    /** Returns the greatest holding impulse, before the tyre's limit, N s. */
    double holding(double seconds);

    /**
     * Solves one pass, unless it holds.
     * @param row along the driving direction
     * @param v velocities of the centre of mass, changed
     * @param rolling speed of the wheel
     * @param rim takes a part of the motor's impulse as it speeds up
     * @param grip greatest impulse of the tyre, N s
     * @param seconds length of the substep
     */
    void solve(ConstraintRow row, double[] v, double rolling, Rim rim, double grip, double seconds);

    /**
     * Ends a substep.
     * @param impulse of the motor at the rim, N s
     * @param rolled speed of the wheel
     * @param grounded whether the wheel was on the ground
     */
    void feel(double impulse, double rolled, boolean grounded, double seconds);

    /**
     * Returns the rim speed of a wheel that slips or hangs in the air.
     * @param impulse on the ground, N s; 0 in the air
     * @param seconds length of the substep
     */
    double slipping(Rim rim, double impulse, double seconds);

    /** Share of its greatest force. */
    double load();

    /** Greatest rim speed; infinite without a limit. */
    double fastest();
}
