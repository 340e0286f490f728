// SPDX-License-Identifier: Apache-2.0
/**
 * LIDAR models that can be simulated, as data: measuring range, angles, baud rates and protocol. Independent of the
 * simulation. Uses no other package of SEAR. Immutable, any thread.
 */
package org.SEAR.protocol.lidar;
