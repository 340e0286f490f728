/**
 * The running world: loop, commands in, snapshots out. Knows neither MyRobotLab nor a display. May use {@link org.SEAR.robot} and below. {@link
 * org.SEAR.simulator.SimulationRunner#run} is the simulation thread; what other threads may call says so.
 */
package org.SEAR.simulator;
