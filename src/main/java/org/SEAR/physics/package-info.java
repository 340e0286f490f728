/**
 * Bodies, contacts and what solves them, on jbullet, which above it only wheels know. May use {@link org.SEAR.collision}, {@link org.SEAR.raycast},
 * {@link org.SEAR.project} and below. Simulation thread.
 */
package org.SEAR.physics;
