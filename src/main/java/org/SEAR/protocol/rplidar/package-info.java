/**
 * Slamtec's protocol of the RPLIDAR A1 as firmware and driver share it: requests, descriptors, nodes, capsules. Uses no other package of SEAR. Any
 * thread. Numbers of several bytes have the lowest first. Source: Slamtec, interface protocol and application notes.
 */
package org.SEAR.protocol.rplidar;
