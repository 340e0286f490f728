/**
 * Servos: how they turn to the angle that they were given, and what the weight that they turn asks of them. May use {@link org.SEAR.devices}, {@link
 * org.SEAR.project} and below. Simulation thread.
 */
package org.SEAR.robot.servo;
