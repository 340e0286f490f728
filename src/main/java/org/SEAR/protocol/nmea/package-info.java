// SPDX-License-Identifier: Apache-2.0
/**
 * NMEA 0183 sentences and MediaTek's commands: frames and checksums, for the simulated receiver and for the driver.
 * Uses no other package of SEAR. A reader serves one thread.
 */
package org.SEAR.protocol.nmea;
