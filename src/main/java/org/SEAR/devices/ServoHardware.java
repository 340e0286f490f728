// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

/**
 * A servo of a robot, for firmware and scripts. Angles in degrees, + counter-clockwise seen from above. Simulation
 * thread only.
 */
public interface ServoHardware {
    /** Name of its object. */
    String getName();

    /**
     * Turns to an angle as fast as possible.
     *
     * @throws IllegalArgumentException that names the servo, the value and the legal range
     */
    void setAngle(double degrees);

    /** Current angle. */
    double getAngle();

    /** Smallest possible angle. */
    double getMinAngle();

    /** Largest possible angle. */
    double getMaxAngle();
}
