/**
 * Measurement equations: what each sensor reads when the truth is known, its errors, what is told of a reading, its registry. Uses
 * {@link org.SEAR.project} and {@link org.SEAR.raycast}, and what these use. Simulation thread, without allocation in the loops of beams.
 */
package org.SEAR.sensors;
