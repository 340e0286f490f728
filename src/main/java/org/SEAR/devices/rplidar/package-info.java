/** The firmware of Slamtec's RPLIDAR A1. May use {@link org.SEAR.devices} and {@link org.SEAR.protocol.rplidar}. Simulation thread. */
package org.SEAR.devices.rplidar;
