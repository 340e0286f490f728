// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import org.SEAR.parallel.WorkerPool;
import org.SEAR.simulator.SimulationRunner;

/**
 * Settings of simulations, from the system properties that the command line sets: {@code sear.headless} (true or
 * false), {@code sear.speed} (simulated seconds per second, or {@code max}: lock-step, as fast as possible),
 * {@code sear.seed} (a whole number) and {@code sear.threads} (a whole number; default: the number of processors).
 * Immutable.
 */
public final class RunSettings {
    /** Default seed. */
    public static final long DEFAULT_SEED = 1;

    private static final String MAX = "max";

    /** Whether to open no window even with a display. */
    public final boolean headless;
    /** Simulated seconds per second; infinity = as fast as possible. */
    public final double speed;
    /** Whether time advances only in simSleep and step. */
    public final boolean lockStep;
    /** Seed of all random numbers. */
    public final long seed;
    /** Whether beams hit floors and terrain. */
    public final boolean groundVisible;

    /** Number of threads that compute sensors. */
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
     * @throws IllegalArgumentException with property, value and legal values
     */
    public static RunSettings fromSystem() {
        String speed = System.getProperty("sear.speed", "1");
        boolean max = MAX.equals(speed);
        return new RunSettings(Boolean.getBoolean("sear.headless"), max ? Double.POSITIVE_INFINITY : factor(speed), max,
            seed(), true, threads());
    }

    private static double factor(String text) {
        try {
            return SimulationRunner.checkedSpeed(Double.parseDouble(text));
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("sear.speed is \"" + text + "\", legal: a number of "
                + SimulationRunner.SLOWEST + " or more, or max", e);
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
