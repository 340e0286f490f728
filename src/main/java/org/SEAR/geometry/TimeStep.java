package org.SEAR.geometry;

/** Time step of the simulation; physics, devices and the loop all use it. */
public final class TimeStep {
    /** Length of a step, simulated seconds. */
    public static final double SECONDS = 1 / 60.0;

    private TimeStep() {
    }
}
