/**
 * The firmware of a compass and of an inertial measurement unit. Uses {@link org.SEAR.devices} and {@link org.SEAR.protocol.nmea}, and what these
 * use. Simulation thread.
 */
package org.SEAR.devices.imu;
