// SPDX-License-Identifier: Apache-2.0
/**
 * Servos: hinges that a motor turns to a commanded angle; motors that drive joints. Uses {@link org.SEAR.devices} and
 * {@link org.SEAR.physics.joint}. Simulation thread.
 */
package org.SEAR.robot.servo;
