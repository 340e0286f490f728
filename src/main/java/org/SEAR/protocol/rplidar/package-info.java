// SPDX-License-Identifier: Apache-2.0
/**
 * Slamtec's protocol of the RPLIDAR A1 for firmware and driver: requests, descriptors, nodes and capsules. Uses no
 * other package of SEAR. Any thread. Numbers have their low byte first. Source: Slamtec, interface protocol and
 * application notes.
 */
package org.SEAR.protocol.rplidar;
