// SPDX-License-Identifier: Apache-2.0
/**
 * Firmware of Slamtec's RPLIDAR A1. Uses {@link org.SEAR.devices} and {@link org.SEAR.protocol.rplidar}, and their
 * dependencies. Simulation thread.
 */
package org.SEAR.devices.rplidar;
