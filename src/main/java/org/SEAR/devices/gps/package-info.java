/**
 * The firmware of the GPS receivers of MediaTek and u-blox. May use {@link org.SEAR.devices}, {@link org.SEAR.protocol.nmea} and
 * {@link org.SEAR.protocol.ubx}. Simulation thread.
 */
package org.SEAR.devices.gps;
