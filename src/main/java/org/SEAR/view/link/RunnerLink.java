// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.link;

import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.BooleanSupplier;
import org.SEAR.project.Project;
import org.SEAR.scene.BeamFan;
import org.SEAR.scene.BeamFans;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.SEAR.simulator.Snapshot;

/** Link to the world of a runner in this process. */
public final class RunnerLink implements WorldLink {
    private final SimulationRunner runner;
    private final Simulation simulation;
    private final BooleanSupplier scriptDrives;
    private final ExecutorService steps;
    private final CameraWatch watch;

    public RunnerLink(SimulationRunner runner, BooleanSupplier scriptDrives) {
        this.runner = runner;
        this.scriptDrives = scriptDrives;
        simulation = runner.getSimulation();
        steps = Executors.newSingleThreadExecutor(task -> {
            Thread stepper = new Thread(task, "SEAR window steps");
            stepper.setDaemon(true);
            return stepper;
        });
        watch = new CameraWatch(simulation);
        simulation.post(world -> watch(world, true));
    }

    /** Watches all sensors except cameras, whose pictures are taken on request. */
    private static void watch(Simulation world, boolean on) {
        for (String name : world.getSensorNames()) {
            if (!world.getSensor(name).takesPictures()) {
                world.watch(name, on);
            }
        }
    }

    @Override
    public Project project() {
        return simulation.getProject();
    }

    @Override
    public List<BeamFan> beams() {
        return BeamFans.of(project());
    }

    @Override
    public Snapshot snapshot() {
        return simulation.snapshot();
    }

    @Override
    public boolean isPaused() {
        return runner.isPaused();
    }

    @Override
    public double measuredSpeed() {
        return runner.getMeasuredSpeed();
    }

    @Override
    public double wantedSpeed() {
        return runner.getSpeed();
    }

    @Override
    public boolean scriptDrives() {
        return scriptDrives.getAsBoolean() || runsCommands();
    }

    /** Returns whether a device accepts drive commands, such as a Roomba in safe or full mode. */
    private boolean runsCommands() {
        return simulation.snapshot().robots.stream().anyMatch(robot -> robot.commanded);
    }

    @Override
    public void setPaused(boolean paused) {
        runner.setPaused(paused);
    }

    @Override
    public void setSpeed(double factor) {
        runner.setSpeed(factor);
    }

    @Override
    public void singleStep() {
        runner.setPaused(true);
        steps.execute(() -> {
            try {
                runner.advance(1);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
    }

    @Override
    public void drive(int robot, double speed, double radius) {
        simulation.post(DriveCommand.circle(robot, speed, radius));
    }

    @Override
    public void reset() {
        simulation.ask(world -> {
            world.reset();
            return null;
        });
    }

    @Override
    public void wantContacts(boolean on) {
        simulation.post(world -> world.showContacts(on));
    }

    @Override
    public void wantPicture(String camera) {
        watch.want(camera);
    }

    @Override
    public CameraFrame picture() {
        return watch.shot();
    }

    @Override
    public void close() {
        watch.close();
        steps.shutdownNow();
        simulation.post(world -> watch(world, false));
    }
}
