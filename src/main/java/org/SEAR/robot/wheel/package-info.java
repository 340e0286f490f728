// SPDX-License-Identifier: Apache-2.0
/**
 * Wheels of one robot: ground contact, springs, grip, obstacles, steering and motors. Uses {@link org.SEAR.physics} and
 * {@link org.SEAR.robot.servo}. Simulation thread.
 */
package org.SEAR.robot.wheel;
