// SPDX-License-Identifier: Apache-2.0
/**
 * Drivers of real and simulated scanners, one per protocol behind {@link org.myrobotlab.service.lidar.LidarDevice}.
 * Uses {@link org.SEAR.protocol.lms}, {@link org.SEAR.protocol.rplidar}, {@link org.SEAR.protocol.scip} and
 * {@link org.myrobotlab.service.lidar.requests}, and what these use. Bytes arrive on the port's thread, time-outs on a
 * timer; a lock of the driver orders both and the callers.
 */
package org.myrobotlab.service.lidar;
