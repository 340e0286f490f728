package org.SEAR.geometry;

/** How finely simulated time is cut; physics, devices and the loop count in the same steps. */
public final class TimeStep {
    /** Length of a step, simulated seconds. */
    public static final double SECONDS = 1 / 60.0;

    private TimeStep() {
    }
}
