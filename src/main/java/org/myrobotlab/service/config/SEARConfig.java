// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.config;

/**
 * Saved configuration of a SEAR service. The project's folder is {@code SEARproject} in MyRobotLab's working folder.
 */
public class SEARConfig extends ServiceConfig {
    /** Whether closing the simulator window stops the simulation; otherwise it continues without a window. */
    public boolean closingWindowStops;
}
