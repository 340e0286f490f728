// SPDX-License-Identifier: Apache-2.0
/**
 * Firmware of SICK's LMS200. Uses {@link org.SEAR.devices} and {@link org.SEAR.protocol.lms}, and their dependencies.
 * Simulation thread.
 */
package org.SEAR.devices.lms;
