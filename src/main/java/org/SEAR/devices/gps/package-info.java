/** The firmware of MediaTek's GPS receivers. May use {@link org.SEAR.devices} and {@link org.SEAR.protocol.nmea}. Simulation thread. */
package org.SEAR.devices.gps;
