/**
 * The firmware of a compass and of an inertial measurement unit. May use {@link org.SEAR.devices} and {@link org.SEAR.sensors}. Simulation thread.
 */
package org.SEAR.devices.imu;
