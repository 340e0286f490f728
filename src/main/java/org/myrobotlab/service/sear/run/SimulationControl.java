// SPDX-License-Identifier: Apache-2.0
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
import org.SEAR.files.LongWork;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.myrobotlab.service.sear.Host;

/** Starts and ends the simulation of one SEAR service. The whole program runs one simulation at a time. Any thread. */
public final class SimulationControl {
    private static volatile SimulationControl running;

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

    /** @param folder supplies the project's folder at each start */
    public SimulationControl(Host host, Supplier<Path> folder) {
        this.host = host;
        this.folder = folder;
        this.scriptSession = new ScriptSession(text -> host.warn(text));
    }

    /**
     * Starts the project's world.
     *
     * @throws ProjectException with every problem of the project
     * @throws IOException if the folder is missing or a port is not available
     */
    public void start(boolean debugShapes) throws ProjectException, IOException {
        synchronized (SimulationControl.class) {
            if (running != null && running.isRunning()) {
                throw new IllegalStateException(
                    running == this ? "the simulation runs already: call stopSimulation() first"
                    : "service " + running.host.getName() + " runs a simulation: stop it first");
            }
            stop();
            LibraryCheck.check();
            Path project = folder.get();
            if (!Files.isDirectory(project)) {
                throw new IOException("there is no project folder " + project.toAbsolutePath()
                    + ": create some objects first (org.SEAR.POJOs), or loadProject(\"file.sear\")");
            }
            ProjectSwap.claim(project);
            Runnable reported = LongWork.listen(host::progress);
            try {
                session = SimulationSession.start(project, settings(), debugShapes, host, stepListener, startListener);
            } finally {
                reported.run();
            }
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
        return new RunSettings(fromSystem.headless, speed == null ? defaultSpeed : speed, stepped, fromSystem.seed,
            groundVisible, threads == null ? fromSystem.threads : threads);
    }

    /** Sets the actions that objects created before a start perform in its world. Call before the first start. */
    public void setActs(ScriptSession.Acts forObjects) {
        acts = forObjects;
    }

    /** Sets a listener for each step of lock-step, on the thread that advances time. Call before the first start. */
    public void setStepListener(SimulationSession.StepListener listener) {
        stepListener = listener;
    }

    /**
     * Sets a listener for each world before its first step, on the thread that starts it; its exception aborts the
     * start. Call before the first start.
     */
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

    /** Returns whether a world exists. */
    public boolean isRunning() {
        SimulationSession present = session;
        return present != null && present.isRunning();
    }

    /**
     * Returns the running simulation.
     *
     * @throws IllegalStateException if none runs
     */
    public SimulationSession session() {
        SimulationSession present = session;
        if (present == null || !present.isRunning()) {
            throw new IllegalStateException("no simulation runs: startSimulation() first");
        }
        return present;
    }

    /** Returns the running simulation; null if none runs. */
    public SimulationSession sessionOrNull() {
        SimulationSession present = session;
        return present != null && present.isRunning() ? present : null;
    }

    /**
     * Answers a repeated query. A stop during the query is no error.
     *
     * @param question answered on the simulation thread, between two steps
     * @param none the answer if no simulation runs, or if it ends first
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

    /** Returns the simulation that a service of this program runs; null if none runs. */
    public static SimulationSession sessionOfAny() {
        SimulationControl present = running;
        return present == null ? null : present.sessionOrNull();
    }

    /**
     * Throws if a service of this program runs a simulation. All services share one project, so a call of any of them
     * would take the project away from under that simulation.
     *
     * @param call name of the call that replaces the project
     */
    public void refuseWhileAnyRuns(String call) {
        SimulationControl present = running;
        if (present != null && present.isRunning()) {
            throw new IllegalStateException(
                call + (present == this ? " needs the simulation to be stopped: stopSimulation() first"
                : " needs the simulation of service " + present.host.getName() + " to be stopped, because both have "
                + "the one project: " + present.host.getName() + ".stopSimulation() first"));
        }
    }

    /** Returns the present session, even while it starts or ends; null if there is none. */
    public SimulationSession anySession() {
        return session;
    }

    /**
     * Sets the speed of this and later simulations.
     *
     * @param factor simulated seconds per second; infinity = as fast as possible
     */
    public void setSpeed(double factor) {
        speed = SimulationRunner.checkedSpeed(factor);
        if (isRunning()) {
            session().setSpeed(factor);
        }
    }

    /** Switches lock-step of this and later simulations. */
    public void setLockStep(boolean on) throws InterruptedException {
        lockStep = on;
        if (isRunning()) {
            session().setLockStep(on);
        }
    }

    /** Sets whether beams hit floors and terrain in later simulations. */
    public void setGroundVisible(boolean on) {
        if (isRunning()) {
            throw new IllegalStateException("setGroundVisible needs the simulation to be stopped: call it before "
                + "startSimulation()");
        }
        groundVisible = on;
    }

    /**
     * Sets the number of threads that compute sensors in this and later simulations.
     *
     * @throws IllegalArgumentException with the legal range
     */
    public void setThreads(int number) {
        threads = WorkerPool.checked(number);
        if (isRunning()) {
            session().getSimulation().post(world -> world.setThreads(number));
        }
    }

    /** Returns the session in which scripts create objects; closed at first. */
    public ScriptSession scriptSession() {
        return scriptSession;
    }

    public Path getFolder() {
        return folder.get();
    }
}
