// SPDX-License-Identifier: Apache-2.0
/**
 * A simulated Arduino: its pins, the connected components, and its programs: two in Java, or a compiled sketch. The
 * programs access only pins and the serial line. Uses {@link org.SEAR.devices}, {@link org.SEAR.devices.arduino.avr},
 * {@link org.SEAR.protocol.firmata} and {@link org.SEAR.protocol.mrlcomm}, and their dependencies. Simulation thread.
 */
package org.SEAR.devices.arduino;
