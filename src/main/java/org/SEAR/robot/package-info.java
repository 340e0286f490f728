/**
 * A robot in the physics: body, hardware, and the truth that its sensors read; its wheels are in {@link org.SEAR.robot.wheel}. May use {@link
 * org.SEAR.physics}, {@link org.SEAR.devices}, {@link org.SEAR.sensors} and below. Simulation thread.
 */
package org.SEAR.robot;
