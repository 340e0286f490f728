// SPDX-License-Identifier: Apache-2.0
/**
 * Telegrams of SICK's LMS2xx: frames, CRC, command codes, baud rates and variants, for the simulated scanner and for
 * the driver. Uses no other package of SEAR. A reader serves one thread.
 */
package org.SEAR.protocol.lms;
