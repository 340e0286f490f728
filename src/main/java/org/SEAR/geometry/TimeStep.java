// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/** Time step of the simulation; physics, devices and the loop all use it. */
public final class TimeStep {
    /** Length of a step, simulated seconds. */
    public static final double SECONDS = 1 / 60.0;

    /** Tolerance for rounding errors of a number of periods. */
    private static final double ROUNDING = 1e-9;

    private TimeStep() {
    }

    /**
     * Returns the number of periods of a rate that have ended. What is due at a rate is due when this number grows, so
     * that the mean rate is exact although each event waits for the end of a step.
     *
     * @param time simulated seconds since the rate began
     * @param rate Hz, above 0
     */
    public static long periods(double time, double rate) {
        return (long) Math.floor(time * rate + ROUNDING);
    }
}
