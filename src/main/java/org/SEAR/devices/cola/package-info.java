/**
 * The firmware of SICK's LMS1xx and TiM scanners, which speak CoLa A and B over a network. Uses {@link org.SEAR.devices} and
 * {@link org.SEAR.protocol.cola}, and what these use. Simulation thread.
 */
package org.SEAR.devices.cola;
