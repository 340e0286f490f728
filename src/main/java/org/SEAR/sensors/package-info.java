/**
 * Measurement equations: what each sensor reads when the truth is known, its errors, what is told of a reading, its registry. May use {@link
 * org.SEAR.raycast}, {@link org.SEAR.project} and the object grammar. Simulation thread, without allocation in the loops of beams.
 */
package org.SEAR.sensors;
