// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Loop of the simulation thread. Paces steps to real time, to a factor of it, or runs as fast as possible. Pauses,
 * answers queries and services device lines between steps. All methods except {@link #run} may be called from any
 * thread.
 */
public final class SimulationRunner implements Runnable {
    private static final double NANOS = 1e9;
    /** Slowest factor: one step takes some 17 s. A slower one would look like a fault. */
    public static final double SLOWEST = 0.001;
    /** Interval, ns, of checks whether the host that opened a port now waits for the device. */
    private static final long LOOK_AFTER_OPENER = 2_000_000;
    /** Interval, ns, at which listeners get {@link Simulation#idle} while time stands still. */
    private static final long STANDING = 1_000_000_000;
    private static final long SILENT = Long.MIN_VALUE;
    private static final long LOOK_MILLIS = 200;
    /** Tolerance of {@link #sleep} for rounding errors of summed steps, s. */
    private static final double ROUNDING = Simulation.STEP / 1000;
    /** Real time over which the speed is measured, ns, and number of samples in it. */
    private static final long SPEED_WINDOW = 1_000_000_000L;
    private static final int SPEED_SAMPLES = 8;
    /** Rate of new readings in snapshots, per second of real time, approximately. */
    private static final double DISPLAY_RATE = 30;

    private final Simulation simulation;
    private final CopyOnWriteArrayList<Runnable> listeners = new CopyOnWriteArrayList<>();
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition progress = lock.newCondition();
    private final long[] sampleTimes = new long[SPEED_SAMPLES];
    private final long[] sampleSteps = new long[SPEED_SAMPLES];
    private int samples;
    private volatile int waiting;
    private volatile double speed = 1;
    private volatile boolean paused;
    private volatile boolean stopped;
    private volatile boolean ended;
    private volatile Throwable failure;
    private volatile double measured;
    private volatile Thread thread;
    /** Steps of the world; {@link #done} counts those whose outputs are delivered, too. */
    private volatile long advanced;
    private volatile long done;
    private volatile long ordered;
    private volatile boolean newPace;
    private final Pace pace = new Pace();
    /** Time of the first wake-up since lines were last serviced, ns; {@link #SILENT} if there was none. */
    private volatile long rung = SILENT;

    public SimulationRunner(Simulation simulation) {
        this.simulation = simulation;
    }

    /** Runs until {@link #stop}, then closes the simulation. The calling thread becomes the simulation thread. */
    @Override
    public void run() {
        thread = Thread.currentThread();
        simulation.setWakeUp(this::ring);
        try {
            newPace = true;
            while (!stopped) {
                simulation.answerQueries();
                if (paused && done >= ordered) {
                    simulation.answer();
                    measured = 0;
                    samples = 0;
                    newPace = true;
                    rest();
                } else if (isDue()) {
                    advanceOne();
                }
            }
        } catch (RuntimeException | Error e) {
            failure = e;
            throw e;
        } finally {
            simulation.close();
            ended = true;
            report();
        }
    }

    /** Waits for a request or a timeout; the timeout is short while a host is opening a port. */
    private void rest() {
        LockSupport.parkNanos(this, simulation.isOpening() ? LOOK_AFTER_OPENER : STANDING);
        simulation.idle();
    }

    /** Whether the next step is due; if not, services the lines and waits. */
    private boolean isDue() {
        if (newPace) {
            newPace = false;
            pace.restart();
        }
        long now = System.nanoTime();
        if (pace.isDue(now, speed)) {
            return true;
        }
        serviceLines(now);
        return false;
    }

    /** Bytes start at the time of their wake-up, however late a busy processor runs this thread. */
    private void serviceLines(long now) {
        long written = rung;
        if (written != SILENT) {
            rung = SILENT;
            simulation.serviceDevices(pace.part(written));
        }
        int next = simulation.serviceDevices(pace.part(now));
        LockSupport.parkNanos(this, pace.waitFor(next, System.nanoTime()));
    }

    private void ring() {
        if (rung == SILENT) {
            rung = System.nanoTime();
        }
        LockSupport.unpark(thread);
    }

    private void advanceOne() {
        simulation.advance();
        advanced++;
        simulation.deliver();
        done++;
        measure();
        for (Runnable listener : listeners) {
            listener.run();
        }
        if (waiting > 0) {
            report();
        }
    }

    private void report() {
        lock.lock();
        try {
            progress.signalAll();
        } finally {
            lock.unlock();
        }
    }

    private void measure() {
        if (samples > 0 && done % SPEED_SAMPLES != 0) {
            return;
        }
        long now = System.nanoTime();
        int newest = (samples + SPEED_SAMPLES - 1) % SPEED_SAMPLES;
        if (samples > 0 && now - sampleTimes[newest] < SPEED_WINDOW / SPEED_SAMPLES) {
            return;
        }
        int slot = samples % SPEED_SAMPLES;
        int oldest = samples < SPEED_SAMPLES ? 0 : slot;
        if (samples > 0) {
            measured = (done - sampleSteps[oldest]) * Simulation.STEP * NANOS / (now - sampleTimes[oldest]);
            simulation.setDisplayInterval((int) Math.max(2, measured / Simulation.STEP / DISPLAY_RATE));
        }
        sampleTimes[slot] = now;
        sampleSteps[slot] = done;
        samples = samples == 2 * SPEED_SAMPLES - 1 ? SPEED_SAMPLES : samples + 1;
    }

    public Simulation getSimulation() {
        return simulation;
    }

    /** Adds a callback that runs on the simulation thread after each step. */
    public void addStepListener(Runnable listener) {
        listeners.add(listener);
    }

    /** @param factor simulated seconds per real second, at least 0.001; infinity = as fast as possible */
    public void setSpeed(double factor) {
        speed = checkedSpeed(factor);
        newPace = true;
        LockSupport.unpark(thread);
    }

    /**
     * Returns the factor if {@link #setSpeed} accepts it.
     *
     * @throws IllegalArgumentException that states the legal range
     */
    public static double checkedSpeed(double factor) {
        if (!(factor >= SLOWEST)) {
            throw new IllegalArgumentException("speed is " + factor + ", legal: " + SLOWEST
                + " or more (1 = real time, float('inf') = as fast as possible); pause() stops time");
        }
        return factor;
    }

    /** Requested factor; default 1. */
    public double getSpeed() {
        return speed;
    }

    /** Simulated seconds per real second over about the last second; 0 while paused. */
    public double getMeasuredSpeed() {
        return measured;
    }

    /** Pauses or resumes. While paused (and always in lock-step) only {@link #advance} makes steps. */
    public void setPaused(boolean on) {
        paused = on;
        LockSupport.unpark(thread);
    }

    public boolean isPaused() {
        return paused;
    }

    /** Whether {@link #run} makes no further steps: it is stopping, has failed, or has ended. */
    public boolean isEnding() {
        return stopped || failure != null || ended;
    }

    /** Whether {@link #run} has ended. */
    public boolean isEnded() {
        return ended;
    }

    /**
     * Advances by a number of steps, also while paused. Returns when they are done, at the current speed.
     *
     * @throws IllegalStateException if the run ended before, or on the simulation thread
     */
    public void advance(long steps) throws InterruptedException {
        notOnSimulationThread("advance");
        lock.lock();
        waiting++;
        try {
            ordered = Math.max(ordered, done) + steps;
            long goal = ordered;
            LockSupport.unpark(thread);
            while (done < goal && !ended) {
                progress.await();
            }
            if (done < goal) {
                throw new IllegalStateException("the simulation has ended", failure);
            }
        } finally {
            waiting--;
            lock.unlock();
        }
    }

    /** Simulated seconds that this runner has advanced the world by. A reset does not change it. */
    public double getAdvancedTime() {
        return advanced * Simulation.STEP;
    }

    /** Waits for a number of simulated seconds, regardless of resets, or until the run has ended. */
    public void sleep(double seconds) throws InterruptedException {
        sleep(seconds, () -> { });
    }

    /**
     * Waits as {@link #sleep(double)}.
     *
     * @param look runs five times a second meanwhile, on the waiting thread
     */
    public void sleep(double seconds, Runnable look) throws InterruptedException {
        notOnSimulationThread("sleep");
        lock.lock();
        waiting++;
        try {
            double end = getAdvancedTime() + seconds - ROUNDING;
            while (getAdvancedTime() < end && !ended) {
                if (!progress.await(LOOK_MILLIS, TimeUnit.MILLISECONDS)) {
                    look.run();
                }
            }
        } finally {
            waiting--;
            lock.unlock();
        }
    }

    private void notOnSimulationThread(String method) {
        if (Thread.currentThread() == thread) {
            throw new IllegalStateException(method + " on the simulation thread would wait for itself");
        }
    }

    /**
     * Ends {@link #run} after the current step. Waits for its end, except on the simulation thread or before
     * {@link #run} began.
     */
    public void stop() {
        stopped = true;
        Thread runs = thread;
        if (runs == null || Thread.currentThread() == runs) {
            return;
        }
        LockSupport.unpark(runs);
        lock.lock();
        try {
            while (!ended) {
                progress.await();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            lock.unlock();
        }
    }
}
