// SPDX-License-Identifier: Apache-2.0
/**
 * A simulated Arduino: its pins, the connected components, and the two programs that it can run. The programs access
 * only pins and the serial line. Uses {@link org.SEAR.devices}, {@link org.SEAR.protocol.firmata} and
 * {@link org.SEAR.protocol.mrlcomm}, and their dependencies. Simulation thread.
 */
package org.SEAR.devices.arduino;
