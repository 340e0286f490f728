// SPDX-License-Identifier: Apache-2.0
/**
 * Firmware of Hokuyo's scanners. Uses {@link org.SEAR.devices} and {@link org.SEAR.protocol.scip}, and their
 * dependencies. Simulation thread.
 */
package org.SEAR.devices.scip;
