/** The firmware of Hokuyo's scanners. May use {@link org.SEAR.devices} and {@link org.SEAR.protocol.scip}. Simulation thread. */
package org.SEAR.devices.scip;
