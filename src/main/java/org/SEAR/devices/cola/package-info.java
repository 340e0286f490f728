// SPDX-License-Identifier: Apache-2.0
/**
 * Firmware of SICK's LMS1xx and TiM scanners, with CoLa A and B over a network. Uses {@link org.SEAR.devices} and
 * {@link org.SEAR.protocol.cola}, and their dependencies. Simulation thread.
 */
package org.SEAR.devices.cola;
