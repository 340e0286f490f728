// SPDX-License-Identifier: Apache-2.0
/**
 * Firmware of iRobot's Roomba and Create: commands, modes, sensor packets and streams of the Open Interface. Uses
 * {@link org.SEAR.devices} and its dependencies. Simulation thread.
 */
package org.SEAR.devices.oi;
