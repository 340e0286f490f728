package org.SEAR.view.link;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.Project;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.SensorTypes;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.SEAR.simulator.Snapshot;

/** The world of a runner in this process. */
public final class RunnerLink implements WorldLink {
    private final SimulationRunner runner;
    private final Simulation simulation;
    private final BooleanSupplier scriptDrives;
    private final ExecutorService steps;
    /** The unit of each sensor's reading. */
    private final Map<String, String> sensors = new LinkedHashMap<>();
    private Snapshot last;
    private SceneState sceneState;

    public RunnerLink(SimulationRunner runner, BooleanSupplier scriptDrives) {
        this.runner = runner;
        this.scriptDrives = scriptDrives;
        simulation = runner.getSimulation();
        steps = Executors.newSingleThreadExecutor(task -> {
            Thread stepper = new Thread(task, "SEAR window steps");
            stepper.setDaemon(true);
            return stepper;
        });
        SensorTypes types = SensorTypes.load();
        for (SEARrobot robot : project().getRobots()) {
            for (SearObject part : robot.getComponents()) {
                sensors.put(part.getFullName(), types.unit(part));
            }
        }
        simulation.post(world -> watch(world, true));
    }

    private static void watch(Simulation world, boolean on) {
        for (String name : world.getSensorNames()) {
            world.watch(name, on);
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
    public synchronized SceneState sceneState() {
        Snapshot snapshot = simulation.snapshot();
        if (snapshot != last) {
            last = snapshot;
            sceneState = sceneState(snapshot);
        }
        return sceneState;
    }

    private SceneState sceneState(Snapshot snapshot) {
        List<SceneState.RobotState> robots = new ArrayList<>();
        for (Snapshot.RobotState state : snapshot.robots) {
            robots.add(new SceneState.RobotState(state.name, state.pose, state.speed, state.turnRate, state.wheels, state.parts,
                state.lights, state.devices.stream().map(Snapshot.DeviceState::toString).collect(Collectors.toList())));
        }
        Map<String, double[]> beams = new LinkedHashMap<>();
        Map<String, String> values = new LinkedHashMap<>();
        for (Map.Entry<String, String> sensor : sensors.entrySet()) {
            Reading reading = snapshot.readings.get(sensor.getKey());
            if (reading != null) {
                values.put(sensor.getKey(), reading.words(sensor.getValue()));
                double[] lengths = reading.beams();
                if (lengths != null) {
                    beams.put(sensor.getKey(), lengths);
                }
            }
        }
        return new SceneState(snapshot.step, snapshot.time, snapshot.environment, robots, beams, values, snapshot.contacts, snapshot.warnings);
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
        return scriptDrives.getAsBoolean() || obeysCommands();
    }

    /** Whether a robot's device takes drive commands: who put a Roomba into safe or full mode drives. */
    private boolean obeysCommands() {
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
    public void close() {
        steps.shutdownNow();
        simulation.post(world -> watch(world, false));
    }
}
