// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

/** Settings that determine a run together with the project and the commands. Immutable, any thread. */
public final class RunOrigin {
    /** Seed of the sensors' random numbers. */
    public final long seed;
    /** UTC of simulated time 0, milliseconds since 1970. */
    public final long epochMillis;
    /** Whether beams hit floors and terrain. */
    public final boolean groundVisible;

    public RunOrigin(long seed, long epochMillis, boolean groundVisible) {
        this.seed = seed;
        this.epochMillis = epochMillis;
        this.groundVisible = groundVisible;
    }
}
