/**
 * The requests to a device at a serial line, whatever it speaks: queue, time-outs, repetition, search for its baud rate. Uses
 * {@link org.myrobotlab.service.link}, and what that uses. Under the lock of the driver that uses it.
 */
package org.myrobotlab.service.lidar.requests;
