package org.myrobotlab.service.sear.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.SEAR.POJOs.ScriptSession;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.myrobotlab.service.sear.Host;

/** Starts and ends the simulation of one SEAR service; there is one simulation in the whole program at a time. Any thread. */
public final class SimulationControl {
    private static SimulationControl running;

    private final Host host;
    private final Supplier<Path> folder;
    private final ScriptSession scriptSession;
    private volatile SimulationSession session;
    private Double speed;
    private Boolean lockStep;
    private volatile boolean groundVisible = true;
    private volatile Integer threads;
    private ScriptSession.Acts acts;
    private SimulationSession.StepListener stepListener = published -> { };
    private Consumer<Simulation> startListener = world -> { };

    /** @param folder of the project, asked for each time */
    public SimulationControl(Host host, Supplier<Path> folder) {
        this.host = host;
        this.folder = folder;
        this.scriptSession = new ScriptSession(text -> host.warn(text));
    }

    /**
     * Starts the project's world.
     *
     * @throws ProjectException with every problem of the project
     * @throws IOException if the folder is missing or a port can't be had
     */
    public void start(boolean debugShapes) throws ProjectException, IOException {
        synchronized (SimulationControl.class) {
            if (running != null && running.isRunning()) {
                throw new IllegalStateException(running == this ? "the simulation runs already: stopSimulation() first"
                    : "service " + running.host.getName() + " runs a simulation: stop that first");
            }
            stop();
            LibraryCheck.check();
            Path project = folder.get();
            if (!Files.isDirectory(project)) {
                throw new IOException("there is no project folder " + project.toAbsolutePath()
                    + ": create some objects first (org.SEAR.POJOs), or loadProject(\"file.sear\")");
            }
            session = SimulationSession.start(project, settings(), debugShapes, host, stepListener, startListener);
            running = this;
            session.known();
            scriptSession.begin(acts, this::isRunning);
        }
        reportOthers(session().getSimulation().getProject());
    }

    private void reportOthers(Project project) {
        List<String> names = new ArrayList<>();
        project.getEnvironment().forEach(object -> names.add(object.getName()));
        project.getRobots().forEach(robot -> names.add(robot.getName()));
        String others = scriptSession.ofOthers(names);
        if (!others.isEmpty()) {
            host.progress(others);
        }
    }

    private RunSettings settings() {
        RunSettings fromSystem = RunSettings.fromSystem();
        boolean stepped = lockStep == null ? fromSystem.lockStep : lockStep;
        double defaultSpeed = stepped ? Double.POSITIVE_INFINITY : fromSystem.speed;
        return new RunSettings(fromSystem.headless, speed == null ? defaultSpeed : speed, stepped, fromSystem.seed, groundVisible,
            threads == null ? fromSystem.threads : threads);
    }

    /** What objects that were made before a start do in its world. Before the first start. */
    public void setActs(ScriptSession.Acts forObjects) {
        acts = forObjects;
    }

    /** Called after each step of lock-step, on the thread that advances time. Before the first start. */
    public void setStepListener(SimulationSession.StepListener listener) {
        stepListener = listener;
    }

    /** Called with each world before its first step, on the thread that starts it; what it throws ends the start. Before the first start. */
    public void setStartListener(Consumer<Simulation> listener) {
        startListener = listener;
    }

    /** Ends the simulation. Does nothing if none runs. */
    public void stop() {
        synchronized (SimulationControl.class) {
            if (session != null) {
                session.stop();
                session = null;
            }
            if (running == this) {
                running = null;
                scriptSession.end();
            }
        }
    }

    /** Whether a world exists. */
    public boolean isRunning() {
        SimulationSession present = session;
        return present != null && present.isRunning();
    }

    /**
     * The running simulation.
     *
     * @throws IllegalStateException if there is none
     */
    public SimulationSession session() {
        SimulationSession present = session;
        if (present == null || !present.isRunning()) {
            throw new IllegalStateException("no simulation runs: startSimulation() first");
        }
        return present;
    }

    /** The running simulation; null if there is none. */
    public SimulationSession sessionOrNull() {
        SimulationSession present = session;
        return present != null && present.isRunning() ? present : null;
    }

    /**
     * For those who look again and again: a stop in between is nothing to complain of.
     *
     * @param question answered on the simulation thread, between two steps
     * @param none the answer if no simulation runs, or if it ends before it has answered
     */
    public <T> T look(BiFunction<Simulation, SimulationSession, T> question, T none) throws InterruptedException {
        SimulationSession present = sessionOrNull();
        if (present == null) {
            return none;
        }
        try {
            return present.ask(world -> question.apply(world, present));
        } catch (IllegalStateException e) {
            if (present.isEnding()) {
                return none;
            }
            throw e;
        } catch (InterruptedException e) {
            if (present.isEnding()) {
                Thread.currentThread().interrupt();
                return none;
            }
            throw e;
        }
    }

    /** The present session, even one that begins or ends; null if there is none. */
    public SimulationSession anySession() {
        return session;
    }

    /**
     * Speed of this and the next simulations.
     *
     * @param factor simulated seconds a second; infinity = as fast as possible
     */
    public void setSpeed(double factor) {
        speed = SimulationRunner.checkedSpeed(factor);
        if (isRunning()) {
            session().setSpeed(factor);
        }
    }

    /** Lock-step of this and the next simulations. */
    public void setLockStep(boolean on) throws InterruptedException {
        lockStep = on;
        if (isRunning()) {
            session().setLockStep(on);
        }
    }

    /** Whether beams see floors and terrain in the next simulations. */
    public void setGroundVisible(boolean on) {
        if (isRunning()) {
            throw new IllegalStateException("setGroundVisible needs the simulation to be stopped: call it before startSimulation()");
        }
        groundVisible = on;
    }

    /**
     * On how many threads sensors measure in this and the next simulations.
     *
     * @throws IllegalArgumentException that names the legal range
     */
    public void setThreads(int number) {
        threads = WorkerPool.checked(number);
        if (isRunning()) {
            session().getSimulation().post(world -> world.setThreads(number));
        }
    }

    /** Where the objects of the service are made; closed at first. */
    public ScriptSession scriptSession() {
        return scriptSession;
    }

    /** The project's folder. */
    public Path getFolder() {
        return folder.get();
    }
}
