/**
 * The firmware of Slamtec's RPLIDAR A1. Uses {@link org.SEAR.devices} and {@link org.SEAR.protocol.rplidar}, and what these use. Simulation thread.
 */
package org.SEAR.devices.rplidar;
