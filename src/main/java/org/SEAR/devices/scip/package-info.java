/** The firmware of Hokuyo's scanners. Uses {@link org.SEAR.devices} and {@link org.SEAR.protocol.scip}, and what these use. Simulation thread. */
package org.SEAR.devices.scip;
