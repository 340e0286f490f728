/**
 * The wheels of one robot and what turns them: ground contact, springs, grip, what stands in the way, steering, motors. Uses
 * {@link org.SEAR.physics} and {@link org.SEAR.robot.servo}, and what these use. Simulation thread.
 */
package org.SEAR.robot.wheel;
