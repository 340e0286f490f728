/**
 * Servos: how they turn to the angle that they were given, and what the weight that they turn asks of them. Uses {@link org.SEAR.devices}, and what
 * that uses. Simulation thread.
 */
package org.SEAR.robot.servo;
