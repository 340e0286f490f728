// SPDX-License-Identifier: Apache-2.0
/**
 * Firmware of a compass and of an inertial measurement unit. Uses {@link org.SEAR.devices} and
 * {@link org.SEAR.protocol.nmea}, and their dependencies. Simulation thread.
 */
package org.SEAR.devices.imu;
