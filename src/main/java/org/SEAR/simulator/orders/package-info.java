/**
 * What is done to bodies from outside of their world: the velocities with which they start or that they are given, pushes, and hands that hold. Uses
 * {@link org.SEAR.physics}, and what that uses. Simulation thread; a {@link org.SEAR.simulator.orders.BodyOrder} and where a
 * {@link org.SEAR.simulator.orders.DragSpring} goes are for any.
 */
package org.SEAR.simulator.orders;
