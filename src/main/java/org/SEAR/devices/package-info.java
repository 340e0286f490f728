// SPDX-License-Identifier: Apache-2.0
/**
 * Simulated serial devices: interfaces between firmware and simulation, and the cable between device and port. Uses
 * {@link org.SEAR.protocol} and {@link org.SEAR.sensors}, and their dependencies. Simulation thread, except the host's
 * end of a {@link org.SEAR.devices.SerialLine}.
 */
package org.SEAR.devices;
