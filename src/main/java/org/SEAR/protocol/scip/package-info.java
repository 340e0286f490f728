// SPDX-License-Identifier: Apache-2.0
/**
 * Hokuyo's line protocol SCIP 2.0 for firmware and driver: encoding, checksums, commands, replies, and properties of
 * the scanners. Uses {@link org.SEAR.protocol.lidar} and its dependencies. Any thread. Source: Hokuyo, SCIP 2.0
 * specification C-42-03320B.
 */
package org.SEAR.protocol.scip;
