package org.SEAR.devices;

/** A servo of a robot as firmware and scripts see it. Angles in degrees, + counter-clockwise seen from above. Simulation thread only. */
public interface ServoHardware {
    /** Its name, as that of its object. */
    String getName();

    /**
     * Has it turn to an angle, as fast as it can.
     *
     * @throws IllegalArgumentException that names the servo, the value and the legal range
     */
    void setAngle(double degrees);

    /** Where it is now. */
    double getAngle();

    /** The smallest angle that it can have. */
    double getMinAngle();

    /** The greatest angle that it can have. */
    double getMaxAngle();
}
