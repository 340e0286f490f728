/**
 * The drivers of the scanners, real or simulated, one a protocol behind {@link org.myrobotlab.service.lidar.LidarDevice}. Uses
 * {@link org.SEAR.protocol.lms}, {@link org.SEAR.protocol.rplidar}, {@link org.SEAR.protocol.scip} and
 * {@link org.myrobotlab.service.lidar.requests}, and what these use. The port's thread brings bytes, a timer its time-outs; a lock of the driver's
 * orders both and the callers.
 */
package org.myrobotlab.service.lidar;
