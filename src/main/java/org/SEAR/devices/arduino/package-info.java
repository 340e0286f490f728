/**
 * A simulated Arduino: its pins, what hangs on them, and the two programs that it can run, each of which sees nothing but pins. Uses
 * {@link org.SEAR.devices}, {@link org.SEAR.protocol.firmata} and {@link org.SEAR.protocol.mrlcomm}, and what these use. Simulation thread.
 */
package org.SEAR.devices.arduino;
