/**
 * Servos: how they turn to the angle that they were given, and what the weight that they turn asks of them. Uses {@link org.SEAR.devices} and
 * {@link org.SEAR.physics.solid}, and what these use. Simulation thread.
 */
package org.SEAR.robot.servo;
