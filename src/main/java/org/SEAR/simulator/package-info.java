/**
 * The running world: loop, commands in, snapshots out. Knows neither MyRobotLab nor a display. Uses {@link org.SEAR.physics.start},
 * {@link org.SEAR.robot} and {@link org.SEAR.simulator.orders}, and what these use. {@link org.SEAR.simulator.SimulationRunner#run} is the
 * simulation thread; what other threads may call says so.
 */
package org.SEAR.simulator;
