/** The firmware of SICK's LMS200. May use {@link org.SEAR.devices} and {@link org.SEAR.protocol.lms}. Simulation thread. */
package org.SEAR.devices.lms;
