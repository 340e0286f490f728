package org.SEAR.devices;

import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.Truth;

/** What a device's firmware can reach: its line, its robot's hardware, the sensor it belongs to. Simulation thread only. */
public interface DeviceContext {
    /** Puts bytes on the line to the user's port; they leave one after another at the device's baud rate, the first not before {@code time}. */
    void send(byte[] bytes, double time);

    /** When the last byte that was sent has left the line, simulated seconds. */
    double lineFreeAt();

    /** Throws away what has not yet left the line (a reset, a change of baud rate). */
    void clearOutput();

    /** Throws away what has not left the line by {@code time}, but for the byte that is on it then. */
    void cutOutput(double time);

    /** A command came that the firmware knows: who sent it is at the right port, see {@link Cable#complaint}. */
    void understood();

    /** The robot the device sits on. */
    RobotHardware robot();

    /** The reading of a sensor at the present step. */
    <R extends Reading> R read(Sensor<R> sensor);

    /** The sensor made from the device's own object (LIDAR, GPS); null for a robot's drive. */
    Sensor<?> sensor();

    /**
     * The sensor made from another component of the same robot.
     *
     * @param part name of the component
     * @return null if there is none, or it is no sensor
     */
    Sensor<?> sensor(String part);

    /** The exact state of the robot at the present step, for sensors that are asked for more than their own reading. */
    Truth truth();

    /** Simulated seconds of the present step. */
    double time();

    /** UTC of simulated time 0, milliseconds since 1970. */
    long epochMillis();

    /** The simulation's seed; a reset can bring another one. */
    long seed();

    /**
     * Something the user should know, shown as warning with the device's name.
     *
     * @param cause what the warnings have in common of which only the first is shown, and how many there were, see {@link RepeatedWarnings}
     */
    void warn(String cause, String message);

    /** Something the user should know that has no other form. */
    default void warn(String message) {
        warn(message, message);
    }
}
