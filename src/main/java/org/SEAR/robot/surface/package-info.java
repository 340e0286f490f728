/**
 * What colour things have at a point of their surface, for sensors that look at it, and what they look like to cameras. Uses
 * {@link org.SEAR.camera} and {@link org.SEAR.physics.solid}, and what these use. Simulation thread.
 */
package org.SEAR.robot.surface;
