/**
 * Hokuyo's line protocol SCIP 2.0 as firmware and driver share it: encoding, checksums, commands, replies, what the scanners tell of themselves.
 * Uses {@link org.SEAR.protocol.lidar}, and what that uses. Any thread. Source: Hokuyo, SCIP 2.0 specification C-42-03320B.
 */
package org.SEAR.protocol.scip;
