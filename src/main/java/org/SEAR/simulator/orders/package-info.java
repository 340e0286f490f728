// SPDX-License-Identifier: Apache-2.0
/**
 * Commands to bodies from outside the world: start velocities, velocities, forces and drag springs. Uses
 * {@link org.SEAR.physics} and its dependencies. Simulation thread, except {@link org.SEAR.simulator.orders.BodyOrder}
 * and the targets of {@link org.SEAR.simulator.orders.DragSpring}.
 */
package org.SEAR.simulator.orders;
