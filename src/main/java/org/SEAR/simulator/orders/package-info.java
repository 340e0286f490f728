/**
 * What is done to bodies from outside of their world: the velocities with which they start or that they are given, and pushes. Uses the grammar and
 * the physics. Simulation thread; a {@link org.SEAR.simulator.orders.BodyOrder} is for any.
 */
package org.SEAR.simulator.orders;
