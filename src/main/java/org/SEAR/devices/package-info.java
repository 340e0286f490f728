/**
 * Simulated serial devices: what a firmware sees of the simulation and the simulation of a firmware, and the cable between device and port. Uses
 * {@link org.SEAR.protocol} and {@link org.SEAR.sensors}, and what these use. Simulation thread, but for the user's end of a
 * {@link org.SEAR.devices.SerialLine}.
 */
package org.SEAR.devices;
