// SPDX-License-Identifier: Apache-2.0
/**
 * Servos: motion to a commanded angle and the torque of their load. Uses {@link org.SEAR.devices} and
 * {@link org.SEAR.physics.solid}. Simulation thread.
 */
package org.SEAR.robot.servo;
