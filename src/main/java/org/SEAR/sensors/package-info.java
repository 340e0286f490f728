// SPDX-License-Identifier: Apache-2.0
/**
 * Measurement equations: what each sensor reads given the ground truth, its errors, the forms of a reading, and the
 * registry. Uses {@link org.SEAR.camera}, {@link org.SEAR.camera.image} and {@link org.SEAR.project} and their packages
 * in turn. Simulation thread, without allocation in the loops over beams. Sensors that allow it measure in parallel on
 * other threads ({@link org.SEAR.sensors.ParallelSensing}).
 */
package org.SEAR.sensors;
