package org.SEAR.robot.wheel;

import org.SEAR.physics.ConstraintRow;

/** What turns one driven wheel. Speeds are those of the wheel over ground, along which it drives, m/s. Simulation thread. */
interface WheelMotor {
    /**
     * What the robot was told.
     *
     * @param speed at which it has the wheel roll, unless it has an order of its own
     * @param part speed of the wheel for each m/s of the robot's middle, as it is steered
     */
    void follow(double speed, double part);

    /** Whether it holds the wheel where it is. */
    boolean holds();

    /** Greatest impulse with which it does, if the tyre can give it to the ground, Ns. */
    double holding(double seconds);

    /**
     * One pass of the solver, unless it holds.
     *
     * @param row along which the wheel drives
     * @param v velocities of the centre of mass, changed
     * @param rolling speed of the wheel
     * @param grip greatest impulse of the tyre, Ns
     * @param seconds length of the substep
     */
    void solve(ConstraintRow row, double[] v, double rolling, double grip, double seconds);

    /**
     * Takes notice of what a substep came to.
     *
     * @param impulse that it gave to the ground, Ns; 0 in the air
     * @param rolled speed of the wheel
     * @param grounded whether the wheel was on the ground
     */
    void feel(double impulse, double rolled, boolean grounded, double seconds);

    /**
     * How fast the rim of a wheel turns that slips, or hangs in the air.
     *
     * @param force that it gives to the ground, N
     */
    double slipping(double force);

    /** Share of its greatest force. */
    double load();

    /** The fastest that it turns the rim of its wheel; infinite if it has no limit. */
    double fastest();
}
