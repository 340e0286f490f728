/**
 * Where bodies start: out of one another and on the ground. May use {@link org.SEAR.physics} and below. Any thread, before the world starts.
 */
package org.SEAR.physics.start;
