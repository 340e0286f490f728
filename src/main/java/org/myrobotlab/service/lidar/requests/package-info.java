// SPDX-License-Identifier: Apache-2.0
/**
 * Requests to a device on a serial line, for any protocol: queue, time-outs, repetition, search for the baud rate. Uses
 * {@link org.myrobotlab.service.link}, and what that uses. Call under the driver's lock.
 */
package org.myrobotlab.service.lidar.requests;
