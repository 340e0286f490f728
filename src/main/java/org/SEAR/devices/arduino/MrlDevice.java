// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

/** A device that a MyRobotLab service has attached to MrlComm. */
interface MrlDevice {
    /** Runs in each loop of the program. */
    void loop(double time);

    /** Releases the device's pins. */
    void detach();
}
