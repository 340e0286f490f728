// SPDX-License-Identifier: Apache-2.0
/**
 * Firmware of the GPS receivers of MediaTek and u-blox. Uses {@link org.SEAR.devices}, {@link org.SEAR.protocol.nmea}
 * and {@link org.SEAR.protocol.ubx}, and their dependencies. Simulation thread.
 */
package org.SEAR.devices.gps;
