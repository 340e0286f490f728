// SPDX-License-Identifier: Apache-2.0
/**
 * Sensor readings for scripts and listeners, and commands to drive, actuate and move. Uses
 * {@link org.myrobotlab.service.sear.run}, and what that uses. Any thread; the simulation thread answers the queries.
 */
package org.myrobotlab.service.sear.readings;
