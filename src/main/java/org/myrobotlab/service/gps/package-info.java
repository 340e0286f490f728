// SPDX-License-Identifier: Apache-2.0
/**
 * Fixes, geofences and receiver models of the GPS service. Uses {@link org.SEAR.protocol.nmea},
 * {@link org.SEAR.protocol.ubx} and {@link org.SEAR.geometry}, and what these use. Immutable, except for a connection's
 * {@link Reception}.
 */
package org.myrobotlab.service.gps;
