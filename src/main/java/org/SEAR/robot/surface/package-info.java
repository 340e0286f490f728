/**
 * What colour things have at a point of their surface, for sensors that look at it. Uses {@link org.SEAR.physics.solid}, and what that uses.
 * Simulation thread.
 */
package org.SEAR.robot.surface;
