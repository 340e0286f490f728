/**
 * The drivers of the scanners, real or simulated, one a protocol behind {@link org.myrobotlab.service.lidar.LidarDevice}. May use
 * {@link org.myrobotlab.service.link} and {@link org.SEAR.protocol}. The port's thread brings bytes,
 * a timer its time-outs; a lock of the driver's orders both and the callers.
 */
package org.myrobotlab.service.lidar;
