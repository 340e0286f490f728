/**
 * Measurement equations: what each sensor reads when the truth is known, its errors, what is told of a reading, its registry. Uses
 * {@link org.SEAR.camera}, {@link org.SEAR.camera.image} and {@link org.SEAR.project}, and what these use. Simulation thread, without allocation in
 * the loops of beams; sensors that say so measure on other threads at the same time ({@link org.SEAR.sensors.ParallelSensing}).
 */
package org.SEAR.sensors;
