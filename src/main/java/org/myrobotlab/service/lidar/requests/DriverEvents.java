package org.myrobotlab.service.lidar.requests;

/** What happens on the line to a device. Called on the port's reader thread. */
public interface DriverEvents {
    /** The device was found at another rate than the port was opened with, or told to use one; the port is at that rate now. */
    void baud(int baud);

    void error(String message);

    void info(String message);
}
