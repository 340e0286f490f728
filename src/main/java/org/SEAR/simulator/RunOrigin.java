package org.SEAR.simulator;

/** What, beside the project and the commands, decides what happens in a run. Immutable, any thread. */
public final class RunOrigin {
    /** Where the random numbers of the sensors begin. */
    public final long seed;
    /** UTC of simulated time 0, milliseconds since 1970. */
    public final long epochMillis;
    /** Whether beams see floors and terrain. */
    public final boolean groundVisible;

    public RunOrigin(long seed, long epochMillis, boolean groundVisible) {
        this.seed = seed;
        this.epochMillis = epochMillis;
        this.groundVisible = groundVisible;
    }
}
