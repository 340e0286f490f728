package org.myrobotlab.service.sear.run;

import org.SEAR.parallel.WorkerPool;
import org.SEAR.simulator.SimulationRunner;

/**
 * How simulations are to run, from the system properties that the command line sets: {@code sear.headless} (true or false), {@code sear.speed}
 * (simulated seconds a second, or {@code max}: lock-step, as fast as possible), {@code sear.seed} (a whole number) and {@code sear.threads} (a
 * whole number; as many as there are processors unless set). Immutable.
 */
public final class RunSettings {
    /** Seed unless another is given. */
    public static final long DEFAULT_SEED = 1;

    private static final String MAX = "max";

    /** No window, even where there is a display. */
    public final boolean headless;
    /** Simulated seconds a second; infinity = as fast as possible. */
    public final double speed;
    /** Whether time advances only inside simSleep and step. */
    public final boolean lockStep;
    /** Of all random numbers. */
    public final long seed;
    /** Whether beams see floors and terrain. */
    public final boolean groundVisible;

    /** How many threads sensors measure on. */
    public final int threads;

    RunSettings(boolean headless, double speed, boolean lockStep, long seed, boolean groundVisible, int threads) {
        this.headless = headless;
        this.speed = speed;
        this.lockStep = lockStep;
        this.seed = seed;
        this.groundVisible = groundVisible;
        this.threads = threads;
    }

    /**
     * Reads the properties.
     *
     * @throws IllegalArgumentException that names property, value and what is legal
     */
    public static RunSettings fromSystem() {
        String speed = System.getProperty("sear.speed", "1");
        boolean max = MAX.equals(speed);
        return new RunSettings(Boolean.getBoolean("sear.headless"), max ? Double.POSITIVE_INFINITY : factor(speed), max, seed(), true,
            threads());
    }

    private static double factor(String text) {
        try {
            return SimulationRunner.checkedSpeed(Double.parseDouble(text));
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("sear.speed is \"" + text + "\", legal: a number of " + SimulationRunner.SLOWEST
                + " or more, or max", e);
        }
    }

    private static long seed() {
        String text = System.getProperty("sear.seed", String.valueOf(DEFAULT_SEED));
        try {
            return Long.parseLong(text);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("sear.seed is \"" + text + "\", legal: a whole number", e);
        }
    }

    private static int threads() {
        String text = System.getProperty("sear.threads", String.valueOf(WorkerPool.threadsOfMachine()));
        if (!WorkerPool.isLegal(text)) {
            throw new IllegalArgumentException("sear.threads is \"" + text + "\", legal: " + WorkerPool.LEGAL);
        }
        return Integer.parseInt(text);
    }
}
