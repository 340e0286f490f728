// SPDX-License-Identifier: Apache-2.0
/**
 * Robots in the physics: body, hardware, and the ground truth for sensors; the wheels are in
 * {@link org.SEAR.robot.wheel}. Uses {@link org.SEAR.robot.surface} and {@link org.SEAR.robot.wheel}. Simulation
 * thread.
 */
package org.SEAR.robot;
