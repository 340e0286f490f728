/**
 * What the GPS service reads out of sentences. Uses {@link org.SEAR.protocol.nmea} and {@link org.SEAR.protocol.ubx}, and what these use. Immutable.
 */
package org.myrobotlab.service.gps;
