// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.Function;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.lockstep.Quiescence;
import org.myrobotlab.service.sear.lockstep.SleepingThreads;

/**
 * One running simulation with its thread, ports and clock. Any thread. {@code stepping} is held while lock-step
 * advances time; its holder waits only for ports and the simulation thread.
 */
public final class SimulationSession {
    private static final long LOOK_AFTER_THREAD = 200;
    private static final long READER_TIMEOUT = TimeUnit.MILLISECONDS.toNanos(50);
    private static final long READER_LOOK = TimeUnit.MICROSECONDS.toNanos(100);
    private static final long LOOK_AFTER_SLEEPERS = 1;
    private static final int MOST_ROUNDS = 500;
    /** Tolerance of a sum of steps against the requested time, s. */
    private static final double ROUNDING = Simulation.STEP / 1000;
    private static final long THREAD_END = TimeUnit.SECONDS.toMillis(10);

    private final Host host;
    private final StepListener stepListener;
    private final Simulation simulation;
    private final SimulationRunner runner;
    private final Thread thread;
    private final List<UartLine> lines = new CopyOnWriteArrayList<>();
    private final Object closing = new Object();
    private final OptionalWindow window = new OptionalWindow();
    private final Throttle throttle;
    private final ClockTrap clockTrap;
    private final Quiescence quiescence;
    private final PortOrder turns;
    private final Object stepping = new Object();
    /** The thread that advances time; null if none does. Guarded by {@link #stepping}. */
    private Thread stepper;
    private final Pauses pauses;
    private final PendingDrives orders = new PendingDrives();
    /** Number of calls that have advanced time. */
    private final AtomicLong sleeps = new AtomicLong();
    private volatile SimulationClock clock;
    private volatile boolean lockStep;
    private volatile boolean ended;
    private boolean stopped;
    /** Guarded by {@link #stepping}. */
    private boolean lateReported;
    private volatile Throwable failure;
    /** Simulated end of the script's last sleep, s: {@link SimulationRunner#getAdvancedTime} not rounded to steps. */
    private volatile double scriptTime;
    private final SleepingThreads sleepers = new SleepingThreads();
    private final ReportedWarnings warnings;
    private final OutOfMemoryWatch memoryWatch = new OutOfMemoryWatch(this::outOfMemory);
    private final MemoryAlarm memoryAlarm;

    /** Publishes what is due after a step of lock-step. */
    public interface StepListener {
        /** @param published waits for callbacks; run after each published message */
        void stepped(SleepingThreads.Work published) throws InterruptedException;
    }

    private SimulationSession(Simulation simulation, RunSettings settings, Host host, StepListener stepListener) {
        this.host = host;
        this.stepListener = stepListener;
        warnings = new ReportedWarnings(host);
        pauses = new Pauses(host);
        this.simulation = simulation;
        runner = new SimulationRunner(simulation);
        lockStep = settings.lockStep;
        throttle = new Throttle(settings.speed);
        clockTrap = new ClockTrap(host);
        clock = new SimulationClock(simulation, lockStep);
        quiescence = new Quiescence(host, sleepers);
        turns = new PortOrder(lines, this::settle);
        memoryAlarm = new MemoryAlarm(MemoryAlarm.NEARLY_FULL, host::warn);
        thread = new Thread(this::run, "SEAR simulation");
        thread.setDaemon(true);
    }

    /**
     * Reads the project and starts its world.
     *
     * @param stepListener called after each step of lock-step, on the thread that advances time
     * @throws ProjectException with every problem of the project
     * @throws IOException if a port is not available; releases everything else
     */
    public static SimulationSession start(Path folder, RunSettings settings, boolean debugShapes, Host host,
            StepListener stepListener, Consumer<Simulation> startListener) throws ProjectException, IOException {
        Simulation world = Simulation.load(folder, settings.seed, settings.groundVisible);
        world.setThreads(settings.threads);
        SimulationSession session = new SimulationSession(world, settings, host, stepListener);
        try {
            startListener.accept(world);
            session.open(settings, debugShapes);
            return session;
        } catch (IOException | RuntimeException | LinkageError e) {
            session.stop();
            throw e;
        }
    }

    private void open(RunSettings settings, boolean debugShapes) throws IOException {
        clock.install();
        memoryWatch.open();
        memoryAlarm.open();
        Map<SerialLine, String> serviceNames = UartLine.serviceNames(simulation.getLines());
        for (SerialLine line : simulation.getLines()) {
            UartLine uart = new UartLine(line, serviceNames.get(line), host, this::scriptDrives);
            lines.add(uart);
            uart.open(clock);
        }
        runner.setSpeed(lockStep ? Double.POSITIVE_INFINITY : settings.speed);
        runner.setPaused(true);
        runner.addStepListener(this::waitForReaders);
        thread.start();
        quiescence.greet();
        if (!settings.headless) {
            window.open(runner, debugShapes, orders::areRecent, host); // takes seconds, during which time must not pass
        }
        runner.setPaused(lockStep);
        reportWarnings();
    }

    /**
     * Connects the services that wait for its ports, unless in lock-step. Called when the service knows this session.
     */
    void known() {
        if (!lockStep) {
            turns.callBackUsers();
        }
    }

    /** Lets readers take their bytes after each step "as fast as possible". At most 50 ms, so that queries run. */
    private void waitForReaders() {
        if (lockStep || !Double.isInfinite(throttle.getSpeed())) {
            return;
        }
        long end = System.nanoTime() + READER_TIMEOUT;
        while (lines.stream().anyMatch(UartLine::isBehind) && System.nanoTime() < end) {
            LockSupport.parkNanos(READER_LOOK);
        }
    }

    private void run() {
        try {
            runner.run();
        } catch (RuntimeException | Error e) {
            failure = e;
        } finally {
            end();
        }
        if (failure != null) {
            closeLines();
            host.error(describe(failure));
        }
    }

    private String describe(Throwable reason) {
        String what = reason instanceof OutOfMemoryError
            ? "the simulation has ended at " + time() + " s because Java ran out of memory (" + reason.getMessage()
                + "): start Java with more (-Xmx), or make the world smaller"
            : "the simulation broke down at " + time() + " s: " + reason;
        return what + "; its ports are closed";
    }

    /** Ends the simulation after another thread of this program ran out of memory and left its work undone. */
    private void outOfMemory(OutOfMemoryError reason) {
        if (!ended) {
            failure = reason;
            runner.stop();
        }
    }

    private void closeLines() {
        synchronized (closing) {
            lines.forEach(UartLine::close);
            lines.clear();
        }
    }

    /** Ends the simulation and releases its ports, services, window and thread. Repeated calls do nothing. */
    public synchronized void stop() {
        if (stopped) {
            return;
        }
        stopped = true;
        warnings.report(orders.replaced(runner.getAdvancedTime(), true));
        Optional.ofNullable(orders.tooLate(runner.getAdvancedTime())).ifPresent(warnings::reportOfNoTime);
        try {
            window.close();
        } finally {
            endWorld();
        }
    }

    private void endWorld() {
        if (thread.isAlive()) {
            runner.stop();
            joinThread();
        }
        clock.uninstall();
        end();
        memoryWatch.close();
        memoryAlarm.close();
        closeLines();
        simulation.close();
    }

    private void joinThread() {
        try {
            thread.join(THREAD_END);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Returns whether the world exists; true while paused. */
    public boolean isRunning() {
        return !ended;
    }

    /** Returns whether the simulation ends or has ended, so that queries may get no answer. */
    boolean isEnding() {
        return ended || runner.isEnding();
    }

    public Simulation getSimulation() {
        return simulation;
    }

    /** Returns the line whose device end has the given Serial service; null if there is none. */
    UartLine lineOf(String serviceName) {
        return lines.stream().filter(line -> line.getServiceName().equals(serviceName)).findFirst().orElse(null);
    }

    /** Returns the direct path to the device at a user's port; null if the simulation has no such port. */
    public ExternalLine outsideLine(String userPort) {
        for (UartLine line : lines) {
            if (line.getUserPort().getName().equals(userPort)) {
                return line;
            }
        }
        return null;
    }

    /**
     * Delivers bytes from a device's Serial service to the device.
     *
     * @return whether the service belongs to one of the lines
     */
    public boolean toDevice(String serviceName, byte[] bytes) {
        UartLine line = lineOf(serviceName);
        if (line != null) {
            if (line.isDrive()) {
                scriptDrives();
            }
            line.toDevice(bytes);
        }
        return line != null;
    }

    /** Records that a script has moved a robot: the window's keys don't drive it for a while. */
    public void scriptDrives() {
        orders.touch();
        warnings.ordered();
    }

    /**
     * Records a script's drive command, which takes effect from the next step on.
     *
     * @param moves whether it starts the robot
     */
    public void scriptOrders(String robot, String call, String values, boolean moves) {
        orders.give(robot, new PendingDrives.Order(call, values, moves, runner.getAdvancedTime(), sleeps.get()));
    }

    /** Returns the simulated time, seconds. */
    public double time() {
        return simulation.snapshot().time;
    }

    /** Answers a query on the simulation thread, between two steps. */
    public <T> T ask(Function<Simulation, T> question) throws InterruptedException {
        Future<T> answer = simulation.ask(question);
        while (true) {
            try {
                return answer.get(LOOK_AFTER_THREAD, TimeUnit.MILLISECONDS);
            } catch (TimeoutException e) {
                checkRunning();
            } catch (ExecutionException e) {
                throw unwrapped(e);
            }
        }
    }

    private static RuntimeException unwrapped(ExecutionException e) {
        Throwable cause = e.getCause();
        if (cause instanceof IllegalArgumentException) {
            return new IllegalArgumentException(cause.getMessage(), cause);
        }
        return new IllegalStateException(cause.getMessage() == null ? cause.toString() : cause.getMessage(), cause);
    }

    private void checkRunning() {
        if (ended || runner.isEnded()) {
            throw new IllegalStateException(failure == null ? "the simulation was stopped"
                : "the simulation broke down: " + failure, failure);
        }
    }

    /** Waits for an amount of simulated time, even across a reset; in lock-step it advances the time. */
    public void simSleep(double seconds) throws InterruptedException {
        if (!(seconds >= 0) || Double.isInfinite(seconds)) {
            throw new IllegalArgumentException("simSleep of " + seconds + " s, legal: 0 or more");
        }
        if (seconds > 0) {
            pauses.checkSleep();
            sleeps.incrementAndGet();
        }
        if (lockStep) {
            sleepInLockStep(seconds);
        } else {
            Pauses.Sleeper sleeper = pauses.new Sleeper();
            runner.sleep(seconds, () -> sleeper.look(runner.isPaused()));
        }
        checkRunning();
        reportWarnings();
    }

    private void sleepInLockStep(double seconds) throws InterruptedException {
        double start = runner.getAdvancedTime();
        double base = scriptTime <= start && scriptTime > start - Simulation.STEP ? scriptTime : start;
        double target = base + seconds;
        scriptTime = target;
        throttle.begin(start);
        sleepers.whileSleeping(target - ROUNDING, () -> {
            synchronized (stepping) {
                settle();
            }
            while (runner.getAdvancedTime() < target - ROUNDING) {
                pauses.await(() -> !ended && runner.getAdvancedTime() < target - ROUNDING);
                stepIfBefore(target - ROUNDING);
                throttle.await(runner.getAdvancedTime());
            }
        });
    }

    /** Makes one step unless the target time has been reached. One thread at a time, even while it waits for others. */
    private void stepIfBefore(double target) throws InterruptedException {
        checkRunning();
        synchronized (stepping) {
            while (stepper != null && runner.getAdvancedTime() < target && !ended) {
                stepping.wait(LOOK_AFTER_SLEEPERS);
            }
            if (runner.getAdvancedTime() < target && !ended) {
                stepper = Thread.currentThread();
                try {
                    oneStep();
                } finally {
                    stepper = null;
                    stepping.notifyAll();
                }
            }
        }
    }

    /**
     * Makes one step of lock-step. Bytes sent before it have arrived. Delivers the results in one fixed order: port by
     * port in the order of the project, then the due readings. The callbacks of each delivery return before the next.
     */
    private void oneStep() throws InterruptedException {
        turns.callBackUsers();
        rest();
        turns.step(() -> runner.advance(1));
        clock.tick();
        stepListener.stepped(() -> {
            quiescence.disturb();
            settle();
        });
        rest();
    }

    /** Waits until ports and callbacks are idle and devices have answered callers that wait by the computer's clock. */
    private void settle() throws InterruptedException {
        quiescence.settle();
        while (simulation.hasQueries()) {
            ask(world -> {
                world.answer();
                return true;
            });
            quiescence.settle();
        }
    }

    /**
     * Waits until all threads that can run at this moment, including callbacks that slept until now, wait again or have
     * ended. The number of rounds is limited, because a thread may repeat sleeps of zero length forever.
     */
    private void rest() throws InterruptedException {
        settle();
        for (int round = 0; round < MOST_ROUNDS && !ended; round++) {
            boolean waited = sleepers.awaitOthers(runner.getAdvancedTime(), stepping, () -> ended, this::reportLate);
            if (!waited || !quiescence.isDisturbed()) {
                return;
            }
            settle();
        }
    }

    private void reportLate() {
        if (!lateReported) {
            lateReported = true;
            host.warn("a thread whose sleep has ended has not continued for a minute: lock-step goes on without it");
        }
    }

    /** Ends all waiting. */
    private void end() {
        ended = true;
        pauses.close();
        clock.wake();
    }

    /** Advances by a number of steps; pauses a simulation that runs by the clock. */
    public void step(long steps) throws InterruptedException {
        if (steps < 1) {
            throw new IllegalArgumentException("step(" + steps + "), legal: 1 or more");
        }
        if (!lockStep && !pauses.isPaused()) {
            pause();
        }
        sleeps.incrementAndGet();
        double target = runner.getAdvancedTime() + steps * Simulation.STEP - ROUNDING;
        sleepers.whileSleeping(target, () -> {
            while (runner.getAdvancedTime() < target) {
                stepIfBefore(target);
            }
        });
        checkRunning();
        reportWarnings();
    }

    /** Stops time until {@link #resume}; the current step is complete when this returns. */
    public void pause() throws InterruptedException {
        pauses.begin();
        runner.setPaused(true);
        ask(world -> true);
    }

    /** Ends {@link #pause}. */
    public void resume() {
        pauses.end();
        runner.setPaused(lockStep);
        clock.wake();
    }

    public boolean isPaused() {
        return pauses.isPaused();
    }

    /** Switches the power of a serial device. Bytes written to its port so far are lost. */
    public void power(String name, boolean on) throws InterruptedException {
        sleepers.whileSleeping(SleepingThreads.NOW, () -> {
            synchronized (stepping) {
                if (lockStep) {
                    settle();
                }
                ask(world -> {
                    world.power(name, on);
                    return true;
                });
            }
        });
    }

    /**
     * Moves an object to its start pose in a newer state of the project, see {@link Simulation#place}.
     *
     * @param back whether an edit was undone
     * @return whether this world has the object
     */
    public boolean place(String name, Project now, boolean back) throws InterruptedException {
        boolean[] found = new boolean[1];
        sleepers.whileSleeping(SleepingThreads.NOW, () -> {
            synchronized (stepping) {
                found[0] = ask(world -> world.place(name, now, back));
            }
        });
        return found[0];
    }

    /** Returns how much to raise a robot's start to stand at its new place, metres, see {@link Simulation#rise}. */
    public double rise(String robot, Pose by) throws InterruptedException {
        return ask(world -> world.rise(robot, by));
    }

    /** Resets the world to its start. */
    public void reset() throws InterruptedException {
        sleepers.whileSleeping(SleepingThreads.NOW, this::toTheStart);
    }

    private void toTheStart() throws InterruptedException {
        synchronized (stepping) {
            settle();
            ask(world -> {
                world.reset();
                return true;
            });
            orders.reset();
            // warnings present from the start were reported already
            warnings.forgetAllBut(simulation.snapshot().warnings);
            scriptTime = runner.getAdvancedTime();
            SimulationClock fresh = new SimulationClock(simulation, lockStep);
            lines.forEach(line -> line.setClock(fresh));
            clock.moveTickersTo(fresh);
            fresh.install();
            clock.wake();
            clock = fresh;
            settle();
        }
    }

    /** Sets simulated seconds per second; infinity = as fast as possible. */
    public void setSpeed(double factor) {
        throttle.setSpeed(factor);
        if (!lockStep) {
            runner.setSpeed(factor);
        }
    }

    /** Sets whether time advances only in {@link #simSleep} and {@link #step}. */
    public void setLockStep(boolean on) throws InterruptedException {
        sleepers.whileSleeping(SleepingThreads.NOW, () -> changeLockStep(on));
    }

    private void changeLockStep(boolean on) {
        synchronized (stepping) {
            lockStep = on;
            if (on) {
                runner.setPaused(true);
                runner.setSpeed(Double.POSITIVE_INFINITY);
            } else {
                turns.callBackUsers();
                runner.setSpeed(throttle.getSpeed());
                runner.setPaused(pauses.isPaused());
            }
            clock.setLockStep(on);
        }
    }

    public boolean isLockStep() {
        return lockStep;
    }

    /** Returns the requested simulated seconds per second; infinity = as fast as possible. */
    public double getWantedSpeed() {
        return throttle.getSpeed();
    }

    /** Returns the recently measured simulated seconds per second. */
    public double getMeasuredSpeed() {
        return runner.getMeasuredSpeed();
    }

    /** Warns if a script waits by the computer's clock in lock-step. */
    public void lookForClockTrap() {
        clockTrap.look(this);
    }

    /** Publishes new warnings of the simulation. */
    public void reportWarnings() {
        warnings.report(simulation.snapshot().warnings);
        warnings.report(orders.replaced(runner.getAdvancedTime(), false));
    }

    @Override
    public String toString() {
        return String.format(Locale.ROOT, "simulation at %.3f s", time());
    }
}
