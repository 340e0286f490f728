/** The firmware of SICK's LMS200. Uses {@link org.SEAR.devices} and {@link org.SEAR.protocol.lms}, and what these use. Simulation thread. */
package org.SEAR.devices.lms;
