// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar.requests;

/** Receives events of the line to a device, on the port's reader thread. */
public interface DriverEvents {
    /** Called when the port's baud rate has changed, on request or because the device answered at another rate. */
    void baud(int baud);

    void error(String message);

    void info(String message);
}
