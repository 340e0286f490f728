/**
 * Fixes and receiver models of the GPS service. Uses {@link org.SEAR.protocol.nmea} and {@link org.SEAR.protocol.ubx},
 * and what these use. Immutable.
 */
package org.myrobotlab.service.gps;
