/**
 * A robot in the physics: body, wheels with suspension, drive train, and the truth that its sensors read. May use {@link org.SEAR.physics}, {@link
 * org.SEAR.devices}, {@link org.SEAR.sensors} and below. Simulation thread.
 */
package org.SEAR.robot;
