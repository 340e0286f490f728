// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import org.SEAR.devices.SerialLine;

/**
 * Direct path between a device and an external program at its port. Bypasses MyRobotLab's messages and the ports'
 * reader threads, which may wait for a busy processor. Any thread.
 */
public interface ExternalLine {
    /** Sends bytes of the program, which are in transit from the next step on. Never waits. */
    void write(byte[] bytes);

    /**
     * Sets the receiver of the device's bytes; called on the simulation thread, must not wait.
     *
     * @param reader null sends bytes through MyRobotLab again
     */
    void setReader(SerialLine.Sink reader);

    /** Reports that the first program has opened the port. Never waits. */
    void pickUp();

    /** Reports that the last program has closed the port. Never waits. */
    void hangUp();

    /** Returns the device's baud rate. */
    int getDeviceBaud();
}
