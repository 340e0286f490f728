/**
 * Where bodies start: out of one another and on the ground. Uses {@link org.SEAR.physics}, and what that uses. Any thread, before the world starts.
 */
package org.SEAR.physics.start;
