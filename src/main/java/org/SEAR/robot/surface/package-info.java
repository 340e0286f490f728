/**
 * What colour things have at a point of their surface, for sensors that look at it. May use {@link org.SEAR.physics} and {@link org.SEAR.project} and
 * below. Simulation thread.
 */
package org.SEAR.robot.surface;
