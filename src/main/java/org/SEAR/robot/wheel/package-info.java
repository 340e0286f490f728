/**
 * The wheels of one robot and what turns them: ground contact, springs, grip, what stands in the way, steering, motors. May use {@link
 * org.SEAR.robot.servo}, {@link org.SEAR.physics}, {@link org.SEAR.devices} and below. Simulation thread.
 */
package org.SEAR.robot.wheel;
