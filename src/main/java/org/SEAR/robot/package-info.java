/**
 * A robot in the physics: body, hardware, and the truth that its sensors read; its wheels are in {@link org.SEAR.robot.wheel}. Uses
 * {@link org.SEAR.robot.surface} and {@link org.SEAR.robot.wheel}, and what these use. Simulation thread.
 */
package org.SEAR.robot;
