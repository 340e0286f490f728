package org.SEAR.simulator;

import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;

/**
 * The body of the simulation thread: paces steps to real time, a factor of it, or as fast as possible; pauses; serves questions and
 * the lines of devices meanwhile. Whoever runs it gives it a thread. Every method but {@link #run} may be called from any thread.
 */
public final class SimulationRunner implements Runnable {
    private static final double NANOS = 1e9;
    /** A step takes some 17 s then: who waits for less would take it for a fault. */
    public static final double SLOWEST = 0.001;
    /** So often it is looked whether who has opened a port has come to where he waits for its device, ns. */
    private static final long LOOK_AFTER_OPENER = 2_000_000;
    /** So often a record hears that time stands still, ns. */
    private static final long STANDING = 1_000_000_000;
    private static final long SILENT = Long.MIN_VALUE;
    private static final long LOOK_MILLIS = 200;
    /** By which sums of steps may miss the time that was asked for, s. */
    private static final double ROUNDING = Simulation.STEP / 1000;
    /** Real time over which the speed is measured, ns, and how often. */
    private static final long SPEED_WINDOW = 1_000_000_000L;
    private static final int SPEED_SAMPLES = 8;
    /** Snapshots carry fresh readings about this often in real time, per second. */
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
    /** Steps that the world has made, and those whose outputs have gone out, too. */
    private volatile long advanced;
    private volatile long done;
    private volatile long ordered;
    private volatile boolean newPace;
    private final Pace pace = new Pace();
    /** When the bell rang first since lines were attended to last, ns; {@link #SILENT} if it did not. */
    private volatile long rung = SILENT;

    public SimulationRunner(Simulation simulation) {
        this.simulation = simulation;
    }

    /** Runs until {@link #stop}; then closes the simulation. The thread that calls this is the simulation thread. */
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

    /** Until something is asked for, or who has just opened a port may wait for its device by now; or for a while. */
    private void rest() {
        LockSupport.parkNanos(this, simulation.isOpening() ? LOOK_AFTER_OPENER : STANDING);
        simulation.idle();
    }

    /** Whether the next step's time has come; attends to the lines and waits a while if not. */
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

    /** Bytes are on their way from when they were written, however late a busy processor lets this thread see them. */
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

    /** The world that is run. */
    public Simulation getSimulation() {
        return simulation;
    }

    /** Called on the simulation thread after each step. */
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
     * A factor that {@link #setSpeed} takes.
     *
     * @throws IllegalArgumentException that says what is legal
     */
    public static double checkedSpeed(double factor) {
        if (!(factor >= SLOWEST)) {
            throw new IllegalArgumentException("speed is " + factor + ", legal: " + SLOWEST
                + " or more (1 = real time, float('inf') = as fast as possible); pause() stops time");
        }
        return factor;
    }

    /** The factor that was asked for; default 1. */
    public double getSpeed() {
        return speed;
    }

    /** Simulated seconds per real second over the last second or so; 0 while paused. */
    public double getMeasuredSpeed() {
        return measured;
    }

    /** While paused (and always in lock-step) time advances only by {@link #advance}. */
    public void setPaused(boolean on) {
        paused = on;
        LockSupport.unpark(thread);
    }

    public boolean isPaused() {
        return paused;
    }

    /** Whether {@link #run} takes no more steps: it was told to end, broke down, or has ended. */
    public boolean isEnding() {
        return stopped || failure != null || ended;
    }

    /** Whether {@link #run} has ended. */
    public boolean isEnded() {
        return ended;
    }

    /**
     * Advances by so many steps, also while paused, and returns when they are done, at the speed that is set.
     *
     * @throws IllegalStateException if the run ended before, or when called on the simulation thread
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

    /** Simulated seconds that this has advanced the world by. A reset changes nothing about it. */
    public double getAdvancedTime() {
        return advanced * Simulation.STEP;
    }

    /** Waits so many simulated seconds, whether the world is reset meanwhile or not, or until the run has ended. */
    public void sleep(double seconds) throws InterruptedException {
        sleep(seconds, () -> { });
    }

    /**
     * The same.
     *
     * @param look is called five times a second meanwhile, on the thread that waits
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

    /** Ends {@link #run} after the present step; waits for that unless called from the simulation thread or before {@link #run} began. */
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
