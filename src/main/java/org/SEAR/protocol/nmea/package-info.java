/**
 * NMEA 0183 sentences and MediaTek's commands: frames and checksums; for the simulated receiver and for the driver. Uses nothing else. A reader
 * serves one thread.
 */
package org.SEAR.protocol.nmea;
