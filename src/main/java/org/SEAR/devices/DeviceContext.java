// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.io.IOException;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.Truth;

/** Access of a device's firmware to its line, its robot's hardware and its sensor. Simulation thread only. */
public interface DeviceContext {
    /**
     * Puts bytes on the line to the host. They leave one after another at the device's baud rate, the first not before
     * {@code time}.
     */
    void send(byte[] bytes, double time);

    /** Time when the last queued byte has left the line, simulated seconds. */
    double lineFreeAt();

    /** Discards all bytes that have not left the line (reset, change of baud rate). */
    void clearOutput();

    /** Discards the bytes that have not left the line by {@code time}, except the byte being sent then. */
    void cutOutput(double time);

    /**
     * Notes a command that the firmware knows, so that its sender is at the right port, see {@link Cable#complaint}.
     */
    void understood();

    /** Hardware of the device's robot. */
    RobotHardware robot();

    /** Reads a sensor at the current step. */
    <R extends Reading> R read(Sensor<R> sensor);

    /** Sensor of the device's own object (LIDAR, GPS); null for a robot's drive. */
    Sensor<?> sensor();

    /**
     * Finds the sensor of another component of the same robot.
     *
     * @param part name of the component
     * @return null if there is no such component, or it is no sensor
     */
    Sensor<?> sensor(String part);

    /**
     * Returns the bytes of a file below the project's assets.
     *
     * @throws IOException with the expected path, if there is none
     */
    byte[] asset(String path) throws IOException;

    /** Ground truth of the robot at the current step, for devices that report more than their sensor's reading. */
    Truth truth();

    /** Simulated seconds of the current step. */
    double time();

    /** UTC of simulated time 0, milliseconds since 1970. */
    long epochMillis();

    /** Seed of the simulation; a reset can change it. */
    long seed();

    /**
     * Shows a warning to the user, with the device's name.
     *
     * @param cause key of warnings that are counted together: SEAR shows the first, then counts, see
     *     {@link RepeatedWarnings}
     */
    void warn(String cause, String message);

    /** Shows a warning that is its own cause. */
    default void warn(String message) {
        warn(message, message);
    }
}
