// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.nio.file.Path;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.SEAR.simulator.Snapshot;

/** A project's simulation on its own thread. */
final class RunningWorld implements AutoCloseable {
    private static final long SEED = 1;
    final Simulation simulation;
    final SimulationRunner runner;
    final Thread thread;

    RunningWorld(Path project) throws Exception {
        this(project, false);
    }

    /** @param paused whether it waits at its start */
    RunningWorld(Path project, boolean paused) throws Exception {
        simulation = Simulation.load(project, SEED);
        runner = new SimulationRunner(simulation);
        runner.setPaused(paused);
        thread = new Thread(runner, "simulation");
        thread.setDaemon(true);
        thread.start();
    }

    Snapshot snapshot() {
        return simulation.snapshot();
    }

    /** Returns the step at which the simulation is paused, after the current step has ended. */
    long pausedStep() throws Exception {
        return simulation.ask(world -> world.snapshot().step).get();
    }

    Snapshot.RobotState robot() {
        return snapshot().robots.get(0);
    }

    @Override
    public void close() {
        runner.stop();
    }
}
