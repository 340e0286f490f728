// SPDX-License-Identifier: Apache-2.0
/**
 * The running world: the loop, commands in, snapshots out. Independent of MyRobotLab and of any display. Uses
 * {@link org.SEAR.physics.start}, {@link org.SEAR.robot} and {@link org.SEAR.simulator.orders}, and their dependencies.
 * {@link org.SEAR.simulator.SimulationRunner#run} is the simulation thread; methods for other threads say so.
 */
package org.SEAR.simulator;
