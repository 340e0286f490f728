/**
 * What is done to bodies from outside of their world: the velocities with which they start or that they are given, and pushes. Uses
 * {@link org.SEAR.physics}, and what that uses. Simulation thread; a {@link org.SEAR.simulator.orders.BodyOrder} is for any.
 */
package org.SEAR.simulator.orders;
