// SPDX-License-Identifier: Apache-2.0
/**
 * Frames, messages and baud rates of u-blox receivers (UBX, protocol 18), for the simulated receiver and for the
 * driver. Uses no other package of SEAR. A reader serves one thread.
 */
package org.SEAR.protocol.ubx;
