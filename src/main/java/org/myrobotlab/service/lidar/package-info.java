/**
 * The driver of a SICK LMS2xx, real or simulated. May use {@link org.myrobotlab.service.link} and {@link org.SEAR.protocol.lms}. The port's thread
 * brings bytes, a timer its time-outs; a lock of the driver's orders both and the callers.
 */
package org.myrobotlab.service.lidar;
