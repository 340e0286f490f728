/** What the GPS service reads out of sentences. May use {@link org.SEAR.protocol.nmea}. Immutable. */
package org.myrobotlab.service.gps;
