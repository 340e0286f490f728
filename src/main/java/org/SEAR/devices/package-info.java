/**
 * Simulated serial devices: what a firmware sees of the simulation and the simulation of a firmware, and the cable between device and port. May use
 * {@link org.SEAR.sensors} and {@link org.SEAR.protocol}. Simulation thread, but for the user's end of a {@link org.SEAR.devices.SerialLine}.
 */
package org.SEAR.devices;
