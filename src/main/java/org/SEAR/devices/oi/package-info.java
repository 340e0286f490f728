/**
 * The firmware of iRobot's Roomba and Create: commands, modes, sensor packets and streams of the Open Interface. May use {@link org.SEAR.devices}.
 * Simulation thread.
 */
package org.SEAR.devices.oi;
