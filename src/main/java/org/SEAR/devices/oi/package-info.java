/**
 * The firmware of iRobot's Roomba and Create: commands, modes, sensor packets and streams of the Open Interface. Uses {@link org.SEAR.devices}, and
 * what that uses. Simulation thread.
 */
package org.SEAR.devices.oi;
